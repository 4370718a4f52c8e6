"""The exact surface of example 5.2: its distance against a search, its triangulation against the distance."""
import pathlib
import sys
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed")
    sys.exit(0)

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples"))
import true_surface  # noqa: E402

TOLERANCE = 1e-4


def volume(mesh):
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


class TrueSurface(unittest.TestCase):
    def test_distance_is_the_least_over_the_meridian(self):
        points = np.random.default_rng(1).uniform(-1, 1, (200, 3))
        curve = true_surface.meridian(np.linspace(*true_surface.POLES, 100001))[0]
        flat = np.stack([np.hypot(points[:, 0], points[:, 1]), points[:, 2]], axis=1)
        searched = np.array([np.linalg.norm(curve - x, axis=1).min() for x in flat])
        found = true_surface.distance(points)
        self.assertLess((found - searched).max(), 1e-14)
        self.assertLess((searched - found).max(), 1e-7)

    def test_level_is_zero_on_the_surface_and_negative_inside(self):
        points = true_surface.triangulated(TOLERANCE).points
        self.assertLess(np.abs(true_surface.level(points)).max(), 1e-15)
        self.assertLess(true_surface.level(0.9 * points).max(), 0)
        self.assertGreater(true_surface.level(1.1 * points).min(), 0)

    def test_derivatives_are_differences(self):
        phi, step = np.linspace(-1.5, 1.5, 50), 1e-6
        _, first, second = true_surface.meridian(phi)
        (above, above_first, _), (below, below_first, _) = (true_surface.meridian(phi + h) for h in (step, -step))
        self.assertLess(np.abs((above - below) / (2 * step) - first).max(), 1e-8)
        self.assertLess(np.abs((above_first - below_first) / (2 * step) - second).max(), 1e-8)

    def test_triangulation_is_closed_outward_and_near(self):
        mesh = true_surface.triangulated(TOLERANCE)
        sides = np.concatenate([mesh.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
        self.assertEqual(len(np.unique(sides, axis=0)), len(sides))
        self.assertEqual(len(np.unique(np.sort(sides, axis=1), axis=0)), len(sides) // 2)
        self.assertEqual(len(mesh.points) - len(sides) // 2 + len(mesh.triangles), 2)
        corners = mesh.points[mesh.triangles[::20]]
        for weights in ([1, 1, 1], [1, 1, 0], [0, 1, 1], [1, 0, 1]):
            places = np.einsum("k,nkd->nd", np.array(weights) / sum(weights), corners)
            self.assertLess(true_surface.distance(places).max(), TOLERANCE)
        phi = np.linspace(*true_surface.POLES, 100001)
        heights = true_surface.radius(phi) ** 3 * np.cos(phi)
        exact = 2 * np.pi / 3 * (heights.sum() - (heights[0] + heights[-1]) / 2) * (phi[1] - phi[0])
        self.assertAlmostEqual(volume(mesh) / exact, 1, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
