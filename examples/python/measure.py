"""How alike two pictures are.     measure.py"""
import numpy as np

import fastscene

random = np.random.default_rng(1)
picture = np.kron(random.integers(40, 215, (8, 8, 3)), np.ones((8, 8, 1))).astype(np.uint8)
for sigma in (2, 8, 32):
    noisy = np.clip(picture + random.normal(0, sigma, picture.shape), 0, 255).astype(np.uint8)
    print(f"noise {sigma:2}: PSNR {fastscene.psnr(picture, noisy):.1f} dB, SSIM {fastscene.ssim(picture, noisy):.3f}")
try:
    fastscene.psnr(picture, picture[:4])
except fastscene.UsageError as error:
    print("refused:", error)
