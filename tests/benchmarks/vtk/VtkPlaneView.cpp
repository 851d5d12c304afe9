// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/vtk/VtkPlaneView.h"

#include <vtkCellArray.h>
#include <vtkCutter.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>

namespace bench {

struct VtkPlaneView::Parts {
    vtkNew<vtkImageData> image;
    vtkNew<vtkPolyData> surface;
    vtkNew<vtkImageReslice> reslice;
    vtkNew<vtkPlane> plane;
    vtkNew<vtkCutter> cutter;
};

VtkPlaneView::VtkPlaneView(const core::VolumeGeometry& geometry,
    std::span<const std::int16_t> hounsfield, std::span<const glm::dvec3> places,
    std::span<const std::array<std::uint32_t, 3>> triangles)
    : m_parts(std::make_unique<Parts>())
{
    Parts& parts = *m_parts;
    const glm::dvec3 spacing = geometry.spacingMm();
    const glm::dvec3 origin = geometry.originLps();
    parts.image->SetDimensions(geometry.size.x, geometry.size.y, geometry.size.z);
    parts.image->SetSpacing(spacing.x, spacing.y, spacing.z);
    parts.image->SetOrigin(origin.x, origin.y, origin.z);
    vtkNew<vtkShortArray> scalars;
    scalars->SetArray(
        const_cast<short*>(hounsfield.data()), static_cast<vtkIdType>(hounsfield.size()), 1);
    parts.image->GetPointData()->SetScalars(scalars);

    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const glm::dvec3& place : places)
        points->InsertNextPoint(place.x, place.y, place.z);
    vtkNew<vtkCellArray> cells;
    for (const auto& triangle : triangles)
        cells->InsertNextCell(
            {vtkIdType(triangle[0]), vtkIdType(triangle[1]), vtkIdType(triangle[2])});
    parts.surface->SetPoints(points);
    parts.surface->SetPolys(cells);

    parts.reslice->SetInputData(parts.image);
    parts.reslice->SetOutputDimensionality(2);
    parts.reslice->SetBackgroundLevel(-30000.0);
    parts.cutter->SetInputData(parts.surface);
    parts.cutter->SetCutFunction(parts.plane);
}

VtkPlaneView::~VtkPlaneView() = default;

void VtkPlaneView::update(const gpu::SliceScene& scene, const glm::ivec2& size, bool cubic)
{
    Parts& parts = *m_parts;
    const glm::dvec3 normal = glm::cross(scene.rightLps, scene.downLps);
    vtkNew<vtkMatrix4x4> axes;
    for (int i = 0; i < 3; ++i) {
        axes->SetElement(i, 0, scene.rightLps[i]);
        axes->SetElement(i, 1, scene.downLps[i]);
        axes->SetElement(i, 2, normal[i]);
        axes->SetElement(i, 3, scene.centreLps[i]);
    }
    parts.reslice->SetResliceAxes(axes);
    parts.reslice->SetOutputExtent(0, size.x - 1, 0, size.y - 1, 0, 0);
    parts.reslice->SetOutputSpacing(scene.mmPerPixel, scene.mmPerPixel, 1.0);
    parts.reslice->SetOutputOrigin(
        (0.5 - 0.5 * size.x) * scene.mmPerPixel, (0.5 - 0.5 * size.y) * scene.mmPerPixel, 0.0);
    if (cubic)
        parts.reslice->SetInterpolationModeToCubic();
    else
        parts.reslice->SetInterpolationModeToLinear();
    parts.reslice->Update();
    parts.plane->SetOrigin(scene.centreLps.x, scene.centreLps.y, scene.centreLps.z);
    parts.plane->SetNormal(normal.x, normal.y, normal.z);
    parts.cutter->Update();
}

std::vector<double> VtkPlaneView::values() const
{
    const auto* begin =
        static_cast<const short*>(m_parts->reslice->GetOutput()->GetScalarPointer());
    return {begin, begin + m_parts->reslice->GetOutput()->GetNumberOfPoints()};
}

std::vector<std::array<glm::dvec3, 2>> VtkPlaneView::lines() const
{
    std::vector<std::array<glm::dvec3, 2>> lines;
    vtkPolyData* cut = m_parts->cutter->GetOutput();
    vtkNew<vtkIdList> ids;
    vtkCellArray* cells = cut->GetLines();
    for (cells->InitTraversal(); cells->GetNextCell(ids);) {
        for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i) {
            std::array<glm::dvec3, 2> line;
            cut->GetPoint(ids->GetId(i), &line[0].x);
            cut->GetPoint(ids->GetId(i + 1), &line[1].x);
            lines.push_back(line);
        }
    }
    return lines;
}

} // namespace bench
