// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkSimplexDeformation.h"

#include <itkDefaultDynamicMeshTraits.h>
#include <itkDeformableSimplexMesh3DFilter.h>
#include <itkMesh.h>
#include <itkSimplexMesh.h>
#include <itkTriangleCell.h>
#include <itkTriangleMeshToSimplexMeshFilter.h>

#include <chrono>

namespace peer {

ItkDeformed itkDeformed(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles,
    const glm::ivec3& size, std::span<const glm::vec3> gradients, const ItkDeformation& settings)
{
    using TriangleTraits = itk::DefaultDynamicMeshTraits<float, 3, 3, double, double>;
    using SimplexTraits = itk::DefaultDynamicMeshTraits<float, 3, 3, double, double>;
    using Triangles = itk::Mesh<float, 3, TriangleTraits>;
    using Simplex = itk::SimplexMesh<float, 3, SimplexTraits>;
    using ToSimplex = itk::TriangleMeshToSimplexMeshFilter<Triangles, Simplex>;
    using Deform = itk::DeformableSimplexMesh3DFilter<Simplex, Simplex>;

    const auto mesh = Triangles::New();
    for (std::size_t i = 0; i < points.size(); ++i) {
        Triangles::PointType point;
        for (int axis = 0; axis < 3; ++axis)
            point[unsigned(axis)] = points[i][axis];
        mesh->SetPoint(i, point);
    }
    mesh->SetCellsAllocationMethod(Triangles::CellsAllocatedDynamicallyCellByCell);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        Triangles::CellAutoPointer cell;
        cell.TakeOwnership(new itk::TriangleCell<Triangles::CellType>);
        for (int corner = 0; corner < 3; ++corner)
            cell->SetPointId(corner, triangles[i][corner]);
        mesh->SetCell(i, cell);
    }
    const auto toSimplex = ToSimplex::New();
    toSimplex->SetInput(mesh);
    toSimplex->Update();
    const Simplex::Pointer simplex = toSimplex->GetOutput();
    simplex->DisconnectPipeline();

    using Gradients = Deform::GradientImageType;
    const auto image = Gradients::New();
    Gradients::RegionType region;
    for (unsigned axis = 0; axis < 3; ++axis)
        region.SetSize(axis, itk::SizeValueType(size[int(axis)]));
    image->SetRegions(region);
    image->Allocate();
    Gradients::PixelType* pixel = image->GetBufferPointer();
    for (const glm::vec3& gradient : gradients) {
        for (int axis = 0; axis < 3; ++axis)
            (*pixel)[unsigned(axis)] = gradient[axis];
        ++pixel;
    }

    const auto deform = Deform::New();
    deform->SetInput(simplex);
    deform->SetGradient(image);
    deform->SetAlpha(settings.alpha);
    deform->SetBeta(settings.beta);
    deform->SetGamma(settings.gamma);
    deform->SetDamping(settings.damping);
    deform->SetRigidity(settings.rigidity);
    deform->SetIterations(settings.iterations);
    const auto start = std::chrono::steady_clock::now();
    deform->Update();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;

    ItkDeformed result{.positions = {}, .milliseconds = spent.count()};
    const auto* moved = deform->GetOutput()->GetPoints();
    for (auto at = moved->Begin(); at != moved->End(); ++at)
        result.positions.emplace_back(at.Value()[0], at.Value()[1], at.Value()[2]);
    return result;
}

} // namespace peer
