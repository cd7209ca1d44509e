#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reference numbers for tests/support/metric_references.h, from implementations that share nothing with ours.

usage: reference_metrics.py     prints the table
needs: python3-numpy, python3-skimage (Debian)

SSIM is scikit-image's. FLIP is written here straight from the paper's formulas: whole two-dimensional
kernels, double precision, convolution by FFT. The pictures are made by integer arithmetic that the test repeats.
"""
import numpy as np
from scipy.signal import fftconvolve
from skimage.metrics import peak_signal_noise_ratio, structural_similarity


def scene(width, height, kind):
    """The test's pictures: ramps, a bright disc with a hard edge, and what is done to them."""
    x, y = np.meshgrid(np.arange(width), np.arange(height))
    if kind == "shifted":
        x = x - 1
    r = (37 + 3 * x + 2 * y) % 256
    g = (90 + x * y // 7) % 256
    b = (200 - 2 * x + y) % 256
    disc = (x - width // 2) ** 2 + (y - height // 2) ** 2 < (height // 3) ** 2
    picture = np.stack([np.where(disc, 230, r), np.where(disc, 180, g), np.where(disc, 40, b)], axis=-1)
    x, y = np.meshgrid(np.arange(width), np.arange(height))
    if kind == "tinted":
        picture = picture + np.array([4, 0, 0])
    elif kind == "noisy":
        picture = picture + (((x * 7 + y * 13) % 5) - 2)[..., None]
    elif kind == "hole":
        hole = (abs(x - width // 4) < 4) & (abs(y - height // 4) < 3)
        picture = np.where(hole[..., None], 0, picture)
    return np.clip(picture, 0, 255).astype(np.uint8)


def luma(picture):
    return picture.astype(float) @ np.array([0.2126, 0.7152, 0.0722])


def ssim(a, b):
    return structural_similarity(
        luma(a), luma(b), gaussian_weights=True, sigma=1.5, use_sample_covariance=False, data_range=255
    )


XYZ = np.array(
    [
        [10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
        [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
        [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382],
    ]
)
WHITE = XYZ.sum(axis=1)


def ycxcz(picture):
    v = picture / 255.0
    rgb = np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)
    t = rgb @ XYZ.T / WHITE
    return np.stack([116 * t[..., 1] - 16, 500 * (t[..., 0] - t[..., 1]), 200 * (t[..., 1] - t[..., 2])], -1)


def hunt_lab(rgb):
    t = rgb @ XYZ.T / WHITE
    d = 6 / 29
    f = np.where(t > d**3, np.cbrt(t), t / (3 * d * d) + 4 / 29)
    light = 116 * f[..., 1] - 16
    return np.stack(
        [light, 0.01 * light * 500 * (f[..., 0] - f[..., 1]), 0.01 * light * 200 * (f[..., 1] - f[..., 2])], -1
    )


def hyab(a, b):
    d = a - b
    return abs(d[..., 0]) + np.hypot(d[..., 1], d[..., 2])


def convolve(plane, kernel):
    r = kernel.shape[0] // 2
    return fftconvolve(np.pad(plane, r, mode="edge"), kernel[::-1, ::-1], mode="valid")


def flip(reference, test, ppd=0.7 * 3840 / 0.7 * np.pi / 180):
    a, b = ycxcz(reference), ycxcz(test)
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi**2)) * ppd))
    i, j = np.meshgrid(range(-radius, radius + 1), range(-radius, radius + 1))
    z = (i**2 + j**2) / ppd**2
    kernels = []
    for terms in ([(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)]):
        k = sum(w * np.sqrt(np.pi / s) * np.exp(-(np.pi**2) * z / s) for w, s in terms)
        kernels.append(k / k.sum())

    def seen(p):
        q = np.stack([convolve(p[..., c], kernels[c]) for c in range(3)], -1)
        y = (q[..., 0] + 16) / 116
        t = np.stack([y + q[..., 1] / 500, y, y - q[..., 2] / 200], -1) * WHITE
        return hunt_lab(np.clip(t @ np.linalg.inv(XYZ).T, 0, 1))

    error = hyab(seen(a), seen(b)) ** 0.7
    most = hyab(hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1]))) ** 0.7
    knee = 0.4 * most
    color = np.where(error < knee, 0.95 / knee * error, 0.95 + (error - knee) / (most - knee) * 0.05)

    sigma = 0.5 * 0.082 * ppd
    radius = int(np.ceil(3 * sigma))
    i, j = np.meshgrid(range(-radius, radius + 1), range(-radius, radius + 1))
    g = np.exp(-(i**2 + j**2) / (2 * sigma**2))

    def normalised(k):
        return np.where(k > 0, k / k[k > 0].sum(), k / -k[k < 0].sum())

    edge, point = normalised(-i * g), normalised((i**2 / sigma**2 - 1) * g)

    def strength(p, k):
        y = (p[..., 0] + 16) / 116
        return np.hypot(convolve(y, k), convolve(y, k.T))

    feature = np.maximum(abs(strength(a, edge) - strength(b, edge)), abs(strength(a, point) - strength(b, point)))
    return color ** (1 - np.sqrt(feature / np.sqrt(2)))


def main():
    width, height = 96, 64
    a = scene(width, height, "plain")
    for kind in ("shifted", "tinted", "noisy", "hole"):
        b = scene(width, height, kind)
        d = abs(a.astype(int) - b.astype(int))
        m = flip(a, b)
        print(
            f'    {{"{kind}", {d.max()}, {d.mean():.9f}, {np.sqrt((d**2).mean()):.9f}, '
            f"{peak_signal_noise_ratio(a, b, data_range=255):.7f}, {(d.max(axis=-1) > 3).mean():.9f}, "
            f"{ssim(a, b):.7f}, {m.mean():.7f}, {m.max():.6f}}},"
        )
    flat = lambda *c: np.broadcast_to(np.array(c, np.uint8), (48, 48, 3))
    for name, p, q in (
        ("black on white", (0, 0, 0), (255, 255, 255)),
        ("green on blue", (0, 255, 0), (0, 0, 255)),
        ("grey on grey", (100, 100, 100), (104, 104, 104)),
    ):
        print(f"// FLIP of flat {name}: {flip(flat(*p), flat(*q)).mean():.7f}")


if __name__ == "__main__":
    main()
