// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ProbabilityMap.h"
#include "core/masks/LabelGrid.h"
#include "core/masks/MaskParts.h"
#include "core/masks/StoredGrid.h"

#include <cmath>
#include <set>
#include <unordered_set>

namespace core {

namespace {

/// What a header says of a segment.
struct NamedSegment {
    int layer = 0;
    int label = 0;
    QString name;
    std::optional<std::uint32_t> rgb;
    CodedConcept code;
};

std::optional<std::uint32_t> colourOf(const QByteArray& text)
{
    const QList<QByteArray> parts = text.simplified().split(' ');
    std::uint32_t rgb = 0;
    for (const QByteArray& part : parts) {
        bool isNumber = false;
        const double share = part.toDouble(&isNumber);
        if (!isNumber || !(share >= 0.0 && share <= 1.0))
            return std::nullopt;
        rgb = (rgb << 8U) | std::uint32_t(std::lround(share * 255.0));
    }
    return parts.size() == 3 ? std::optional(rgb) : std::nullopt;
}

/// The type among 3D Slicer's seven parts of a terminology.
CodedConcept codeOf(const QString& tags)
{
    const QString name = QStringLiteral("TerminologyEntry:");
    for (const QString& tag : tags.split(QLatin1Char('|'))) {
        if (!tag.startsWith(name))
            continue;
        const QStringList code =
            tag.mid(name.size()).split(QLatin1Char('~')).value(2).split(QLatin1Char('^'));
        if (code.size() == 3 && !code[1].isEmpty())
            return {.scheme = code[0], .value = code[1], .meaning = code[2]};
    }
    return {};
}

/// Segment0_Name, Segment0_LabelValue … of a .seg.nrrd.
std::vector<NamedSegment> namedSegments(const std::map<QByteArray, QByteArray>& keys)
{
    std::vector<NamedSegment> segments;
    for (int number = 0;; ++number) {
        const QByteArray prefix = "Segment" + QByteArray::number(number) + '_';
        const auto value = [&](const char* key) {
            const auto found = keys.find(prefix + key);
            return found == keys.end() ? QByteArray() : found->second;
        };
        if (!keys.contains(prefix + "ID"))
            return segments;
        // Files of older programs know neither layers nor label values: one segment, label 1.
        segments.push_back({.layer = value("Layer").toInt(),
            .label = keys.contains(prefix + "LabelValue") ? value("LabelValue").toInt() : 1,
            .name = QString::fromUtf8(value("Name")).simplified(),
            .rgb = colourOf(value("Color")),
            .code = codeOf(QString::fromUtf8(value("Tags")))});
    }
}

/// Of shares of voxels or probabilities, what belongs to the mask: label 1.
std::vector<std::uint16_t> halfTaken(const StoredGrid& stored, int layer)
{
    std::vector<std::uint16_t> labels(stored.voxels());
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel)
        labels[voxel] =
            ProbabilityMap::byteOf(stored.value(voxel, layer)) >= ProbabilityMap::half ? 1 : 0;
    return labels;
}

/// Whether there are more values than there can be labels. Of a map of labels that was damaged or
/// resampled there are few, where fractions are not counted.
bool hasManyValues(const StoredGrid& stored, int layer)
{
    std::unordered_set<std::int64_t> known;
    std::int64_t last = -1;
    for (std::size_t voxel = 0; voxel < stored.voxels(); ++voxel) {
        const double value = stored.value(voxel, layer);
        if (!(std::abs(value) < 1e9))
            continue;
        const std::int64_t whole = std::llround(value);
        if (whole != last && known.insert(whole).second && known.size() > mostSegments)
            return true;
        last = whole;
    }
    return false;
}

using LayersOnVolume = std::vector<LabelsOnVolume>;

/// Segments in the order of the header, then labels that it does not name.
std::vector<MaskSegment> segmentsOf(
    LayersOnVolume& layers, const std::vector<NamedSegment>& named, const QString& path)
{
    std::vector<MaskSegment> segments;
    const auto take = [&](int layer, int label) {
        auto& voxels = layers[std::size_t(layer)].voxels;
        const auto found = voxels.find(label);
        VoxelRuns runs;
        if (found != voxels.end()) {
            runs = std::move(found->second);
            voxels.erase(found);
        }
        return runs;
    };
    for (const NamedSegment& one : named) {
        if (one.layer < 0 || one.layer >= int(layers.size()))
            continue;
        VoxelRuns voxels = take(one.layer, one.label);
        if (voxels.empty())
            continue;
        segments.push_back(
            {.name = one.name.isEmpty() ? QStringLiteral("Label %1").arg(one.label) : one.name,
                .rgb = one.rgb,
                .code = one.code,
                .voxels = std::move(voxels)});
    }
    std::size_t left = 0;
    for (const LabelsOnVolume& layer : layers)
        left += layer.voxels.size();
    const bool alone = left == 1 && segments.empty();
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        for (auto& [label, voxels] : layers[layer].voxels) {
            const QString name = alone ? maskNameOf(path)
                : layers.size() > 1 ? QStringLiteral("Label %1, layer %2").arg(label).arg(layer + 1)
                                    : QStringLiteral("Label %1").arg(label);
            segments.push_back({.name = name, .rgb = {}, .code = {}, .voxels = std::move(voxels)});
        }
    }
    return segments;
}

} // namespace

Result<MaskOnVolume> readLabelMask(
    const QString& path, const Volume& volume, const Progress& progress)
{
    const Result<StoredGrid> stored = readStoredGrid(path, progress);
    if (!stored)
        return tl::unexpected(stored.error());
    MaskOnVolume mask;
    for (const VolumeProblem& problem : stored->problems) {
        if (problem.caution)
            mask.notes.push_back({.code = MaskNote::Code::GridInDoubt, .doubt = problem.said});
    }
    const bool shares = stored->holdsShares();
    if (shares)
        mask.notes.push_back({.code = MaskNote::Code::Fractional});
    LayersOnVolume layers;
    MaskFit fit{.oneToOne = true};
    std::size_t labels = 0;
    for (int layer = 0; layer < stored->layers; ++layer) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::PlacingMask, layer, stored->layers);
        Result<std::vector<std::uint16_t>> values = shares
            ? halfTaken(*stored, layer)
            : labelsFrom(stored->bytes, stored->type, stored->slope, stored->intercept,
                stored->layers, layer, path);
        if (!values)
            return hasManyValues(*stored, layer) ? holdsImage(path)
                                                 : tl::unexpected(values.error());
        const std::set<std::uint16_t> present(values->begin(), values->end());
        labels += present.size() - present.count(0);
        if (labels > mostSegments)
            return holdsTooManyLabels(path);
        Result<LabelsOnVolume> placed = labelsOn(
            volume.geometry, {.geometry = stored->geometry, .labels = *std::move(values)}, path);
        if (!placed)
            return tl::unexpected(placed.error());
        fit.oneToOne = fit.oneToOne && placed->oneToOne;
        fit.labelled += placed->labelled;
        fit.outside += placed->outside;
        layers.push_back(*std::move(placed));
    }
    if (fit.labelled == 0)
        return hasNoLabel(path);
    mask.segments = segmentsOf(layers, namedSegments(stored->keyValues), path);
    std::uint64_t taken = 0;
    for (const MaskSegment& segment : mask.segments)
        taken += segment.voxels.voxelCount();
    fit.labelledMl = millilitres(fit.labelled, stored->geometry);
    fit.takenMl = millilitres(taken, volume.geometry);
    const std::vector<MaskNote> onFit = notesOn(fit);
    mask.notes.insert(mask.notes.end(), onFit.begin(), onFit.end());
    if (labels > mask.segments.size() && !mask.segments.empty())
        mask.notes.push_back({.code = MaskNote::Code::SegmentsWithoutVoxel,
            .some = labels - mask.segments.size(),
            .all = labels});
    return mask;
}

} // namespace core
