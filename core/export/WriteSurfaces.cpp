// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckSources.h"
#include "core/export/common/MaskSelection.h"
#include "core/measure/MeasuredSize.h"
#include "core/meshfile/MeshWriter.h"
#include "core/surface/SegmentSurface.h"
#include "core/volume/UnevenSlices.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

double millilitresOf(const MeshPart& part)
{
    double mm3 = 0.0;
    const glm::dvec3 middle(part.vertices.front());
    for (const glm::uvec3& triangle : part.triangles)
        mm3 += glm::dot(glm::dvec3(part.vertices[triangle.x]) - middle,
                   glm::cross(glm::dvec3(part.vertices[triangle.y]) - middle,
                       glm::dvec3(part.vertices[triangle.z]) - middle))
            / 6.0;
    return mm3 / 1000.0;
}

MeshPart partOf(
    const Segment& segment, SegmentSurface surface, const VolumeGeometry& geometry, MeshSpace space)
{
    MeshPart part;
    part.name = segment.name;
    part.rgb = segment.rgb;
    part.label = segment.label;
    part.vertices = std::move(surface.vertices);
    part.triangles = std::move(surface.triangles);
    // Half a turn about the superior axis leaves what is outside there.
    const glm::dvec3 turn = space == MeshSpace::Ras ? glm::dvec3(-1, -1, 1) : glm::dvec3(1);
    for (glm::vec3& vertex : part.vertices)
        vertex = glm::vec3(turn * worldBetweenSlices(geometry, glm::dvec3(vertex)));
    if (glm::determinant(glm::dmat3(geometry.indexToWorld)) < 0.0) {
        for (glm::uvec3& triangle : part.triangles)
            std::swap(triangle.y, triangle.z);
    }
    return part;
}

} // namespace

Result<ReportLines> writeSurfaces(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report)
{
    std::vector<MeshPart> parts;
    std::vector<ReportSentence> surfaces;
    // Millilitres that nobody measured are told nowhere.
    const bool isMeasured = unknownSpacing(volume) == UnknownSpacing::Nothing;
    for (std::size_t i = 0; i < selection.segments.size(); ++i) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::MakingSurfaces, int(i), int(selection.segments.size()));
        const Segment& segment = selection.segments[i];
        const auto labels = planeOf(request, segment)->labels;
        parts.push_back(partOf(segment, segmentSurface(labels, segment.label, volume.geometry.size),
            volume.geometry, request.space));
        const auto triangles = std::int64_t(parts.back().triangles.size());
        if (isMeasured)
            surfaces.push_back({ReportCode::SurfaceOf,
                {segment.name, triangles, QString::number(millilitresOf(parts.back()), 'f', 3)}});
        else
            surfaces.push_back({ReportCode::TrianglesOf, {segment.name, triangles}});
    }
    const QString space =
        request.space == MeshSpace::Ras ? QStringLiteral("RAS") : QStringLiteral("LPS");
    Result<void> written;
    ReportCode format = ReportCode::StlFormat;
    switch (request.format) {
    case ExportFormat::Obj:
        format = ReportCode::ObjFormat;
        written = writeObj(path, parts, space);
        break;
    case ExportFormat::Ply:
        format = ReportCode::PlyFormat;
        written = writePly(path, parts, space);
        break;
    case ExportFormat::Gltf:
        format = ReportCode::GltfFormat;
        written = writeGltf(path, parts, space);
        break;
    default:
        written = writeStl(path, parts, space);
        if (parts.size() > 1)
            report.cautions += ReportSentence{ReportCode::OneStlSurface};
    }
    if (!written)
        return tl::unexpected(written.error());
    return ReportLines{
        ReportSentence{ReportCode::Surfaces,
            {inReport(ReportSentence{format}), space, inReport(std::move(surfaces))}},
        ReportSentence{ReportCode::SurfacesSmoothed}};
}

} // namespace core
