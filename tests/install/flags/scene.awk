# The view of a ball, an upright can and a wall by a camera of 320 x 240 pixels, one point a line.
BEGIN {
  for (v = 0; v < 240; ++v) for (u = 0; u < 320; ++u) {
    x = (u - 159.5) / 300; y = (v - 119.5) / 300
    z = 0.9
    # |t (x, y, 1) - c| = r for the ball; the same without y for the can.
    a = x * x + y * y + 1; b = -0.08 * x + 0.02 * y + 0.6; d = b * b - a * (0.0064 + 0.0004 + 0.36 - 0.0025)
    if (d > 0) { t = (b - sqrt(d)) / a; if (t < z) z = t }
    a = x * x + 1; b = 0.1 * x + 0.65; d = b * b - a * (0.01 + 0.4225 - 0.0016)
    if (d > 0) { t = (b - sqrt(d)) / a; if (t < z && y * t > -0.06 && y * t < 0.06) z = t }
    z += 0.0003 * sin(12.9898 * u + 78.233 * v)
    printf "%.6f %.6f %.6f\n", x * z, y * z, z
  }
}
