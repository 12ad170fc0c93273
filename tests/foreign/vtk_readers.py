"""Loads what `stampflow run CASE --vtu` wrote with two readers that are not ours, and measures it.

    pip install meshio vtk
    python tests/foreign/vtk_readers.py out/quickstart

Run by hand; tests/suite/vtu.rs measures the same without Python. A sheet that keeps its volume has that of its flat blank.
"""
import glob, math, os, sys
import meshio, vtk

folder = sys.argv[1]
for path in sorted(glob.glob(os.path.join(folder, "*.vtu"))):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    cells = sizes.GetOutput().GetCellData()
    names = [grid.GetCellData().GetArrayName(i) for i in range(grid.GetCellData().GetNumberOfArrays())]
    volumes = [cells.GetArray("Volume").GetValue(i) for i in range(grid.GetNumberOfCells())]
    areas = [cells.GetArray("Area").GetValue(i) for i in range(grid.GetNumberOfCells())]
    mesh = meshio.read(path)
    kinds = {}
    for block in mesh.cells:
        kinds[block.type] = kinds.get(block.type, 0) + len(block.data)
    assert sum(kinds.values()) == grid.GetNumberOfCells() and sorted(mesh.cell_data) == sorted(names)
    print(f"{os.path.basename(path)}: {grid.GetNumberOfPoints()} points, {kinds}, volume {sum(volumes):.3f} mm3 "
          f"(least cell {min(volumes):.2e}), area {sum(areas):.4f} mm2")
    if path.endswith("_0001.vtu"):
        print("   ", ", ".join(names))
    if "section" in path:
        quads = mesh.cells[0].data.astype(int)
        solid = 0.0  # Pappus: 2 pi times the first moment of the area about the axis
        for quad in quads:
            p = mesh.points[quad]
            for a, b, c in ((0, 1, 2), (0, 2, 3)):
                area = 0.5 * ((p[b][0] - p[a][0]) * (p[c][1] - p[a][1]) - (p[c][0] - p[a][0]) * (p[b][1] - p[a][1]))
                solid += 2 * math.pi * area * (p[a][0] + p[b][0] + p[c][0]) / 3
        print(f"    turned: {solid:.3f} mm3")
for path in sorted(glob.glob(os.path.join(folder, "*.pvd"))):
    print(os.path.basename(path), *[line.strip() for line in open(path) if "DataSet" in line], sep="\n    ")
