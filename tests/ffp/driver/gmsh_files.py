"""Meshes of files."""

import os

import shared
from shared import COARSE, SLICE, drop, content, Mesh, DriverTest


class Meshes(DriverTest):
    """Gmsh files in the place of the generated mesh."""

    def check(self, name, versions, share, *options):
        short = [*options, "--end", "0.003"]
        own, _ = self.run_drop(name, *short)
        mesh = Mesh(name)
        for version in versions:
            path = mesh.write(f"{name}_{version}.msh", version)
            read, found = self.run_drop(f"{name}_{version}", *short, "--mesh", path)
            self.assertEqual(found["inputs"]["mesh"], path)
            self.assert_same_drop(own, read, share)

    def test_triangles(self):
        self.check("mesh2", ("2.2", "4.1"), 1e-9, *COARSE)

    def test_tetrahedra(self):
        self.check("mesh3", ("2.2", "4.1"), 1e-9, *SLICE)

    def test_elastic(self):
        self.check("mesh_elastic", ("2.2",), 1e-9, *COARSE, "--device", "elastic")

    def test_unusable(self):
        def refuse(path, rule, *options):
            code, out, err = drop("--out", "refused", "--mesh", path, *options)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
            self.assertTrue(err.startswith(f"arenite-ffp: --mesh = {path}: "), err)
            self.assertIn(rule, err)
            self.assertFalse(os.path.exists("refused"))

        self.run_drop("mesh_good", *COARSE, "--end", "1e-5")
        self.run_drop("mesh_solid", *SLICE, "--end", "1e-5")
        plane, solid = Mesh("mesh_good"), Mesh("mesh_solid")
        good = plane.write("good.msh", "2.2")
        refuse("absent.msh", "no such file")
        refuse(".", "")
        open("empty.msh", "w").close()
        refuse("empty.msh", "")
        with open("garbage.msh", "wb") as file:
            file.write(bytes(range(256)) * 20)
        refuse("garbage.msh", "")
        with open("cut.msh", "wb") as file:
            file.write(content(".", "good.msh")[:9000])
        refuse("cut.msh", "")
        refuse(good, "tetrahedra", "--kinematics", "slice")
        refuse(solid.write("solid.msh", "4.1"), "triangles")
        self.run_drop("mesh_blunt", *COARSE, "--end", "1e-5", "--tip", "blunt")
        refuse(Mesh("mesh_blunt").write("blunt.msh", "2.2"), "radius of the device in --mesh = 0.04375: must be that of bluedrop, cone at ")
        refuse(good, "must be that of bluedrop, blunt, 0.003794332158 m^3, within 5 %", "--tip", "blunt")
        for region in ("soil", "device"):
            broken = Mesh("mesh_good")
            broken.region_names = {{region: "stone"}.get(n, n): k for n, k in broken.region_names.items()}
            refuse(broken.write(f"no_{region}.msh", "2.2"), region)
        for name in ("bottom", "wall"):
            broken = Mesh("mesh_good")
            del broken.sets[name]
            refuse(broken.write(f"no_{name}.msh", "2.2"), name)
        for name in ("side_minus", "side_plus"):
            broken = Mesh("mesh_solid")
            del broken.sets[name]
            refuse(broken.write(f"no_{name}.msh", "2.2"), name, "--kinematics", "slice")
        for name, rule, change in (
            ("inch", "must be --diameter = 0.0875 m within 2 %; give --diameter 3.44 --length 24.8, or is the mesh not in metres?", lambda x, y, z: (x / 0.0254, y / 0.0254, z)),
            ("raised", "tip of the device, y = 0.1: must be 0 m", lambda x, y, z: (x, y + 0.1, z)),
            ("shallow", "bottom of the soil, y = -0.05: must lie below", lambda x, y, z: (x, max(y, y / 8), z)),
        ):
            broken = Mesh("mesh_good")
            broken.nodes = [change(*node) for node in broken.nodes]
            refuse(broken.write(f"{name}.msh", "2.2"), rule)


if __name__ == "__main__":
    shared.main()
