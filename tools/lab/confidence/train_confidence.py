#!/usr/bin/env python3
"""Trains the detector's confidence and prints confidence_weights.hpp.

  tools/lab/confidence/train_confidence.py [--ablate] EVIDENCE.csv... > confidence_weights.hpp

Reads what quadrille_confidence prints: the terms of the surfaces that the detector considered, and
whether each is right. There is a model for curved and one for flat surfaces. Its log odds are a sum
of weights times terms and products of two terms, fitted by penalised maximum likelihood. From all
products, the script drops those that matter least and fits again, step by step, on three quarters
of the scenes. The smallest form that is nearly as good as the best on the last quarter is fitted to
all scenes and printed. With --keep HEADER the fit starts from the weights of that header and is
pulled back to them; only products with terms that it does not weigh are added, and dropped again.
A new term then needs fewer scenes than all terms together. On stderr the script tells how good the forms are on that quarter, and with
--ablate what each term is worth. It needs only numpy, and some gigabytes of memory for a hundred
thousand surfaces.
"""

import argparse
import csv
import pathlib
import re
import sys

import numpy

KINDS = ("curved", "flat")
# Each fourth seed is held out. Scenes of one seed show the same objects to different sensors.
FOLDS = 4
# Terms are clamped to the range that holds all but this share of the surfaces on either side.
TAIL = 0.003
# Penalty on squared weights in standard units; it keeps them finite if few surfaces are wrong. The
# second is the penalty on differences from weights that are kept, and on what is added to them.
RIDGE, RIDGE_KEPT = 3.0, 100.0
# Number of weights at which no more are dropped, and share of them that is dropped in one step.
LEAST = 5
STEP = 0.1
RESAMPLES = 100
# The surfaces of a family count together at most as much as twice those of the median family.
MAX_FAMILY = 2.0
# Number of surfaces of each kind with which the detector's arithmetic is tested.
EXAMPLES = 4


class Surfaces:
    """Surfaces of one kind: their scenes, whether each is right, its terms as a row, and the log
    odds that are known already."""

    def __init__(self, scenes, right, terms, known=None):
        self.scenes, self.right, self.terms = scenes, right, terms
        self.known = numpy.zeros(len(right)) if known is None else known

    def where(self, keep):
        return Surfaces(self.scenes[keep], self.right[keep], self.terms[keep], self.known[keep])

    def held_out(self):
        seeds = [int(re.search(r"\d+$", scene)[0]) for scene in self.scenes]
        return numpy.array(seeds) % FOLDS == 0

    def shares(self):
        """Returns how much each surface counts."""
        _, family, counts = numpy.unique(self.families(), return_inverse=True, return_counts=True)
        return numpy.minimum(1.0, MAX_FAMILY * numpy.median(counts) / counts)[family]

    def families(self):
        return numpy.array([re.split("[-_]", scene)[0] for scene in self.scenes])


def read_evidence(paths, left_out):
    """Returns the surfaces of each kind, and the names of the terms that are not left out."""
    rows, names = [], None
    for path in paths:
        with open(path, newline="") as file:
            reader = csv.reader(file)
            header = next(reader)
            if names not in (None, header[3:]):
                sys.exit(f"train_confidence.py: {path} has other terms than the files before it")
            names = header[3:]
            rows += reader
    scenes = numpy.array([pathlib.PurePath(row[0]).stem for row in rows])
    kinds, right = (numpy.array([row[k] for row in rows]) for k in (1, 2))
    kept = [k for k, name in enumerate(names) if name not in left_out]
    terms = numpy.array([row[3:] for row in rows], dtype=float)[:, kept]
    finite = numpy.isfinite(terms).all(axis=1)
    surfaces = Surfaces(scenes, right.astype(float), terms)
    return {kind: surfaces.where(finite & (kinds == kind)) for kind in KINDS}, [names[k] for k in kept]


class Kept:
    """The ranges of terms and the weights of products in a header that this script has printed."""

    def __init__(self, path, names):
        text = pathlib.Path(path).read_text()
        number = r"(-?[0-9.e+-]+)"
        ranges = {name: (float(low), float(high)) for low, high, name in
                  re.findall(rf"{{{number}, {number}}}, +// (\w+)", text)}
        self.weights = {}
        for kind in KINDS:
            model = re.search(rf"k{kind.capitalize()}Model.*?}}\);", text, re.S)[0]
            self.weights[kind] = {
                tuple([0, 0, *(names.index(term) for term in re.findall(r"\w+", terms))][-2:]):
                float(weight)
                for terms, weight in re.findall(rf'{{((?:"\w+", )*){number}}}', model)}
        self.weighed = {0} | {k for model in self.weights.values() for product in model for k in product}
        self.ranges = {names.index(name): both for name, both in ranges.items()
                       if names.index(name) in self.weighed}

    def log_odds(self, kind, terms):
        x = numpy.hstack([numpy.ones((len(terms), 1)), terms])
        for k, (low, high) in self.ranges.items():
            x[:, k] = numpy.clip(x[:, k], low, high)
        return sum(weight * x[:, i] * x[:, j] for (i, j), weight in self.weights[kind].items())


def newton(x, surfaces, start, ridge):
    """Maximises the penalised log likelihood by Newton's method with step halving. Returns the
    weights of the columns, of which the first is constant, and their squares in units of their
    variances. The known log odds are added to the sum of the weighted columns."""
    y, known, share = surfaces.right, surfaces.known, surfaces.shares()
    scale = numpy.maximum(x.std(axis=0), 1e-6)
    scale[0] = 1.0
    x = x / scale
    penalty = numpy.full(x.shape[1], ridge)
    penalty[0] = 1e-9

    def cost(w):
        log_odds = known + x @ w
        return share @ (numpy.logaddexp(0, log_odds) - y * log_odds) + penalty @ (w * w) / 2

    w = start * scale
    while True:
        p = 1.0 / (1.0 + numpy.exp(-numpy.clip(known + x @ w, -30, 30)))
        hessian = x.T @ (x * (share * p * (1 - p))[:, None]) + numpy.diag(penalty)
        step = numpy.linalg.solve(hessian, x.T @ (share * (y - p)) - penalty * w)
        while cost(w + step) > cost(w) and abs(step).max() > 1e-6:
            step /= 2
        w += step
        if abs(step).max() < 1e-3:
            return w / scale, w * w / numpy.diag(numpy.linalg.inv(hessian))


class Scaling:
    """Clamps terms, and scales them to mean 0 and deviation 1."""

    def __init__(self, terms, ranges):
        self.ranges = ranges
        clamped = numpy.clip(terms, *ranges)
        self.mean, self.deviation = clamped.mean(axis=0), clamped.std(axis=0) + 1e-6

    def columns(self, terms, form):
        """Returns the products of two scaled terms, where number 0 is the constant 1."""
        z = (numpy.clip(terms, *self.ranges) - self.mean) / self.deviation
        z = numpy.hstack([numpy.ones((len(z), 1)), z])
        i, j = numpy.array(form).T
        return z[:, i] * z[:, j]

    def unscaled(self, form, weights):
        """Returns the weights of the products of unscaled terms."""
        result = dict.fromkeys(form, 0.0)
        offset = numpy.append(0.0, self.mean)
        deviation = numpy.append(1.0, self.deviation)
        for (i, j), weight in zip(form, weights):
            # This multiplies out (x_i - m_i) (x_j - m_j), of which a constant has no m.
            for a, u in [(i, 1.0), (0, -offset[i])] if i else [(0, 1.0)]:
                for b, v in [(j, 1.0), (0, -offset[j])] if j else [(0, 1.0)]:
                    product = min(a, b), max(a, b)
                    value = weight * u * v / (deviation[i] * deviation[j])
                    result[product] = result.get(product, 0.0) + value
        return result


def all_products(terms):
    return [(i, j) for i in range(terms + 1) for j in range(i, terms + 1)]


def smaller_form(form, worth, kept):
    """Drops the weights that are worth least, except those that are kept. A term stays as long as a
    product contains it."""
    inside = {i for product in form if product[0] for i in product}
    free = [k for k, (i, j) in enumerate(form)
            if j and (i or j not in inside) and (i, j) not in kept]
    dropped = sorted(free, key=lambda k: worth[k])[:max(1, int(STEP * len(form)))]
    return [k for k in range(len(form)) if k not in dropped] if free else []


def area(log_odds, right):
    """Returns the area under the curve: the share of right-wrong pairs in the correct order."""
    rank = numpy.empty(len(right))
    rank[numpy.argsort(log_odds)] = numpy.arange(1, len(right) + 1)
    n = right.sum()
    return (rank[right == 1].sum() - n * (n + 1) / 2) / (n * (len(right) - n))


def report(name, surfaces, log_odds, others):
    """Prints the area, how much it is more than that of others, and by families."""
    _, scene = numpy.unique(surfaces.scenes, return_inverse=True)
    rows = numpy.split(numpy.argsort(scene), numpy.cumsum(numpy.bincount(scene))[:-1])
    random = numpy.random.default_rng(0)
    more = []
    for _ in range(RESAMPLES):
        pick = numpy.concatenate([rows[k] for k in random.integers(0, len(rows), len(rows))])
        more.append(numpy.subtract(*(area(o[pick], surfaces.right[pick])
                                     for o in (log_odds, others))))
    total = area(log_odds, surfaces.right)
    loss = (numpy.logaddexp(0, log_odds) - surfaces.right * log_odds).mean()
    families = surfaces.families()
    by_family = (f"{f} {area(log_odds[families == f], surfaces.right[families == f]):.3f}"
                 for f in sorted(set(families)))
    print(f"  {name:32} {total:.4f} ({total - area(others, surfaces.right):+.4f} "
          f"± {numpy.std(more):.4f}), log loss {loss:.4f}; {', '.join(by_family)}", file=sys.stderr)


class Trainer:
    """Trains forms on most scenes of one kind, and judges them on the others."""

    def __init__(self, surfaces, ranges, kept):
        self.kept, self.ridge = kept, RIDGE_KEPT if kept else RIDGE
        out = surfaces.held_out()
        self.seen, self.held_out = surfaces.where(~out), surfaces.where(out)
        self.scaling = Scaling(self.seen.terms, ranges)

    def log_odds(self, form):
        columns = self.scaling.columns(self.seen.terms, form)
        weights, _ = newton(columns, self.seen, numpy.zeros(len(form)), self.ridge)
        return self.held_out.known + self.scaling.columns(self.held_out.terms, form) @ weights

    def forms(self, form):
        """Yields ever smaller forms, from a form down to straight lines in few terms, each with its
        log odds on held-out scenes."""
        everything = self.scaling.columns(self.seen.terms, form)
        held_out = self.scaling.columns(self.held_out.terms, form)
        left, weights = numpy.arange(len(form)), numpy.zeros(len(form))
        while len(left) > LEAST:
            weights, worth = newton(everything[:, left], self.seen, weights, self.ridge)
            yield [form[k] for k in left], self.held_out.known + held_out[:, left] @ weights
            keep = smaller_form([form[k] for k in left], worth, self.kept)
            left, weights = left[keep], weights[keep]


def choose_form(trainer, products, within):
    """Returns the smallest form whose area is within a distance of the largest area."""
    forms = list(trainer.forms(products))
    areas = [area(log_odds, trainer.held_out.right) for _, log_odds in forms]
    for form, log_odds in forms:
        report(f"{len(form)} weights", trainer.held_out, log_odds, forms[0][1])
    return forms[max(k for k, a in enumerate(areas) if a >= max(areas) - within)][0]


def ablate(trainer, form, names):
    chosen = trainer.log_odds(form)
    terms = range(1, len(names))
    lines = [(0, 0)] + [(0, k) for k in terms]
    squares = [(k, k) for k in terms]
    report("straight lines", trainer.held_out, trainer.log_odds(lines), chosen)
    report("parabolas", trainer.held_out, trainer.log_odds(lines + squares), chosen)
    for k in terms:
        rest = [product for product in form if k not in product]
        if rest != form:
            report(f"without {names[k]}", trainer.held_out, trainer.log_odds(rest), chosen)


def train(kind, surfaces, ranges, names, kept, arguments):
    """Returns the weights of the products of unscaled terms, and a few examples."""
    if len(set(surfaces.right)) < 2:
        sys.exit(f"train_confidence.py: needs right and wrong {kind} surfaces; take more scenes")
    print(f"{kind}: {len(surfaces.right)} surfaces of {len(set(surfaces.scenes))} scenes, "
          f"{int(surfaces.right.sum())} right; area under the curve on scenes held out:",
          file=sys.stderr)
    weights_before = kept.weights[kind] if kept else {}
    trainer = Trainer(surfaces, ranges, weights_before)
    if kept:
        report("the weights that are kept", trainer.held_out, trainer.held_out.known,
               trainer.held_out.known)
    products = [product for product in all_products(len(names) - 1)
                if not kept or product in weights_before or not kept.weighed.issuperset(product)]
    form = choose_form(trainer, products, arguments.within)
    if arguments.ablate:
        ablate(trainer, form, names)
    scaling = Scaling(surfaces.terms, ranges)
    columns = scaling.columns(surfaces.terms, form)
    weights, _ = newton(columns, surfaces, numpy.zeros(len(form)), trainer.ridge)
    some = numpy.linspace(0, len(surfaces.right) - 1, EXAMPLES, dtype=int)
    log_odds = surfaces.known[some] + columns[some] @ weights
    unscaled = scaling.unscaled(form, weights)
    for product, weight in weights_before.items():
        unscaled[product] = unscaled.get(product, 0.0) + weight
    return unscaled, list(zip(surfaces.terms[some], 1.0 / (1.0 + numpy.exp(-log_odds))))


def print_weights(names, ranges, models):
    print("#pragma once\n\n#include \"surfaces/evidence/confidence_model.hpp\"\n\n"
          "namespace quadrille {\n\n"
          "// Printed by tools/lab/confidence/train_confidence.py. CONTRIBUTING.md tells what they were fitted to.\n\n"
          "inline constexpr auto kTermRanges = std::to_array<TermRange>({")
    for name, low, high in zip(names[1:], *ranges):
        print(f"    {{{low:.6g}, {high:.6g}}},  // {name}")
    print("});\n")
    for kind, weights in models.items():
        print(f"inline constexpr auto k{kind.capitalize()}Model = "
              "std::to_array<ConfidenceWeight>({")
        for product, weight in sorted(weights.items()):
            row = [f'"{names[k]}"' for k in product if k] + [f"{weight:.7g}"]
            print(f"    {{{', '.join(row)}}},")
        print("});\n")
    print("}  // namespace quadrille")


def write_examples(path, examples):
    """Writes terms of surfaces, and the probabilities that this script computes for them."""
    with open(path, "w") as file:
        file.write("#pragma once\n\n#include \"surfaces/evidence/confidence.hpp\"\n\n"
                   "namespace quadrille::test {\n\n"
                   "/// Terms of a surface, and its probability as numpy computes it.\n"
                   "struct ConfidenceExample {\n  SurfaceKind kind;\n  ConfidenceTerms terms;\n"
                   "  double probability;\n};\n\n"
                   "// Printed by tools/lab/confidence/train_confidence.py --examples.\n"
                   "inline constexpr auto kConfidenceExamples = "
                   "std::to_array<ConfidenceExample>({\n")
        for kind, rows in examples.items():
            for terms, probability in rows:
                values = ", ".join(f"{value:.7g}" for value in terms)
                file.write(f"    {{SurfaceKind::k{kind.capitalize()}, {{{values}}}, "
                           f"{probability:.7g}}},\n")
        file.write("});\n\n}  // namespace quadrille::test\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("csv", nargs="+", help="what quadrille_confidence prints")
    parser.add_argument("--within", type=float, default=0.002,
                        help="area under the curve to give for a smaller form (default: %(default)s)")
    parser.add_argument("--keep", help="header whose weights are kept")
    parser.add_argument("--without", default="", help="terms to leave out, separated by commas")
    parser.add_argument("--examples", help="file to write, for the test of the detector's arithmetic")
    parser.add_argument("--ablate", action="store_true", help="tell what each term is worth")
    arguments = parser.parse_args()
    evidence, names = read_evidence(arguments.csv, arguments.without.split(","))
    names = ["", *names]
    everything = numpy.vstack([surfaces.terms for surfaces in evidence.values()])
    ranges = numpy.quantile(everything, [TAIL, 1 - TAIL], axis=0)
    kept = Kept(arguments.keep, names) if arguments.keep else None
    if kept:
        for k, both in kept.ranges.items():
            ranges[:, k - 1] = both
        for kind, surfaces in evidence.items():
            surfaces.known = kept.log_odds(kind, surfaces.terms)
    models, examples = {}, {}
    for kind, surfaces in evidence.items():
        models[kind], examples[kind] = train(kind, surfaces, ranges, names, kept, arguments)
    used = {k for weights in models.values() for product in weights for k in product}
    idle = [name for k, name in enumerate(names) if k not in used]
    print(f"terms without a weight: {', '.join(idle) or 'none'}", file=sys.stderr)
    print_weights(names, ranges, models)
    if arguments.examples:
        write_examples(arguments.examples, examples)


if __name__ == "__main__":
    main()
