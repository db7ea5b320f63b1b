// The one source of the precompiled headers, which need a target.
