// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/MaskSelection.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <map>

namespace core {

namespace {

/// Which labels occur in each slice of a plane.
std::vector<std::bitset<256>> labelsBySlice(const Volume& volume, const LabelPlaneView& plane)
{
    std::vector<std::bitset<256>> present(std::size_t(volume.geometry.size.z));
    const std::size_t count = voxelsPerSlice(volume);
    for (std::size_t k = 0; k < present.size(); ++k) {
        std::array<bool, 256> seen{};
        for (const std::uint8_t label : plane.labels.subspan(k * count, count))
            seen[label] = true;
        for (std::size_t label = 0; label < seen.size(); ++label)
            present[k].set(label, seen[label]);
    }
    return present;
}

} // namespace

const LabelPlaneView* planeOf(const ExportRequest& request, const Segment& segment)
{
    for (const LabelPlaneView& plane : request.planes) {
        if (plane.plane == segment.plane)
            return &plane;
    }
    return nullptr;
}

Clause whyNoLabelMap(
    const ExportRequest& request, const std::vector<Segment>& segments, const QString& format)
{
    for (std::size_t a = 0; a < segments.size(); ++a) {
        const auto first = planeOf(request, segments[a])->labels;
        for (std::size_t b = a + 1; b < segments.size(); ++b) {
            if (segments[a].plane == segments[b].plane && segments[a].label != segments[b].label)
                continue;
            const auto second = planeOf(request, segments[b])->labels;
            std::size_t shared = 0;
            for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
                shared += first[i] == segments[a].label && second[i] == segments[b].label ? 1U : 0U;
            if (shared != 0)
                return Clause::saying(
                    "'%1' and '%2' overlap in %3 voxels, which one %4 label map "
                    "cannot hold; export them one by one, or as binary DICOM SEG or .seg.nrrd",
                    segments[a].name, segments[b].name, QString::number(shared), format);
        }
    }
    return {};
}

const SegmentCoverage* coverageOf(
    std::span<const SegmentCoverage> coverages, const Segment& segment)
{
    const auto found = std::find_if(coverages.begin(), coverages.end(),
        [&](const SegmentCoverage& each) { return each.label == segment.label; });
    return found == coverages.end() ? nullptr : &*found;
}

std::size_t voxelsPerSlice(const Volume& volume)
{
    return std::size_t(volume.geometry.size.x) * std::size_t(volume.geometry.size.y);
}

Result<MaskSelection> selectMask(const Volume& volume, const ExportRequest& request)
{
    MaskSelection selection;
    std::map<std::uint8_t, std::vector<std::bitset<256>>> presentInPlane;
    for (const Segment& segment : request.segments) {
        const LabelPlaneView* plane = planeOf(request, segment);
        if (plane == nullptr || plane->labels.size() != volume.geometry.voxelCount())
            return failure(ErrorCode::UnknownSegment, segment.name,
                Clause::saying("its label plane is not there"));
        auto [present, isNew] = presentInPlane.try_emplace(segment.plane);
        if (isNew)
            present->second = labelsBySlice(volume, *plane);
        std::vector<int> slices;
        for (std::size_t k = 0; k < present->second.size(); ++k) {
            if (present->second[k].test(segment.label))
                slices.push_back(int(k));
        }
        if (slices.empty()) {
            selection.empty += segment.name;
            continue;
        }
        selection.segments.push_back(segment);
        selection.slices.push_back(std::move(slices));
    }
    if (selection.segments.empty())
        return failure(ErrorCode::NothingToExport, request.file,
            request.segments.empty() ? Clause::saying("no segment is chosen")
                                     : Clause::saying("the chosen segments are empty"));
    return selection;
}

} // namespace core
