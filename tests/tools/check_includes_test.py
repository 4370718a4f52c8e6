"""tools/check_includes accepts the includes that its table allows and names all others."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "tools" / "check_includes"


def check(path, *includes):
    """Exit status and output for a tree of one file with these includes."""
    with tempfile.TemporaryDirectory() as root:
        file = pathlib.Path(root, path)
        file.parent.mkdir(parents=True)
        file.write_text("".join(f"#include {name}\n" for name in includes))
        run = subprocess.run([sys.executable, SCRIPT, root], capture_output=True, text=True)
        return run.returncode, run.stdout


class CheckIncludes(unittest.TestCase):
    def test_accepts_what_the_arrows_allow(self):
        allowed = {
            "src/adapt/a.cpp": ('"adapt/a.hpp"', '"base/ids.hpp"', '"taut/adapt.hpp"', "<fmt/format.h>", "<vector>"),
            "src/operators/a.hpp": ('"sizing/target.hpp"', '"geometry/model.hpp"', '"locate/background.hpp"'),
            "src/sizing/a.hpp": ('"surface/sectors.hpp"', '"mesh/build.hpp"', '"metric/length.hpp"'),
            "src/cavity/a.hpp": ('"partition/block.hpp"', '"geometry/model.hpp"'),
            "src/metric/a.cpp": ("<Eigen/Dense>",),
            "src/elasticity/a.cpp": ("<Eigen/SparseCore>", '"mesh/tet_mesh.hpp"', '"base/parallel.hpp"'),
            "apps/taut/a.cpp": ('"taut/taut.hpp"', "<CLI/CLI.hpp>"),
        }
        for path, includes in allowed.items():
            with self.subTest(path):
                self.assertEqual(check(path, *includes)[0], 0)

    def test_names_each_forbidden_include(self):
        forbidden = {
            "src/mesh/a.hpp": '"cavity/cavity.hpp"',
            "src/cavity/a.hpp": '"sizing/target.hpp"',
            "src/geometry/a.hpp": '"partition/block.hpp"',
            "src/elasticity/a.hpp": '"metric/length.hpp"',
            "src/io/a.cpp": '"base/ids.hpp"',
            "src/mesh/b.cpp": "<Eigen/Dense>",
            "src/mesh/b.hpp": "<fmt/format.h>",
            "include/taut/a.hpp": '"base/ids.hpp"',
            "apps/taut/a.cpp": '"mesh/tet_mesh.hpp"',
        }
        for path, include in forbidden.items():
            with self.subTest(path):
                status, output = check(path, "<vector>", include)
                self.assertEqual(status, 1)
                self.assertIn(f"{path}:2:", output)

    def test_refuses_a_room_without_a_row_and_a_long_file(self):
        self.assertEqual(check("src/attic/a.hpp")[0], 1)
        self.assertEqual(check("src/mesh/a.cpp", *["<vector>"] * 301)[0], 1)


if __name__ == "__main__":
    unittest.main()
