// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/SlicePlaces.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <set>

namespace core {

namespace {

QByteArray hashOfFile(const QString& path)
{
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return {};
    return hash.result();
}

} // namespace

std::vector<SlicePlace> sortIntoPlaces(std::vector<ImageHeader> images)
{
    // Scanners round positions; slices of micro-CT may be closer than their rounding.
    const glm::dvec2 pixel = *images.front().spacing;
    const double samePlaceMm = std::min(0.01, 0.05 * std::min(pixel.x, pixel.y));
    const glm::dvec3 normal = images.front().plane->normal();
    const auto along = [&](const ImageHeader& image) { return glm::dot(*image.position, normal); };
    std::stable_sort(images.begin(), images.end(),
        [&](const ImageHeader& a, const ImageHeader& b) { return along(a) < along(b); });
    std::vector<SlicePlace> places;
    for (ImageHeader& image : images) {
        const double here = along(image);
        if (places.empty() || here - places.back().along > samePlaceMm)
            places.push_back({.along = here});
        places.back().images.push_back(std::move(image));
    }
    return places;
}

bool FileContents::areEqual(const QString& file, const QString& other)
{
    return file == other
        || (QFileInfo(file).size() == QFileInfo(other).size() && hashOf(file) == hashOf(other));
}

const QByteArray& FileContents::hashOf(const QString& file)
{
    const auto known = m_hashes.find(file);
    return known != m_hashes.end() ? known->second
                                   : m_hashes.emplace(file, hashOfFile(file)).first->second;
}

std::vector<VolumeProblem> dropDuplicates(std::vector<SlicePlace>& places, FileContents& contents)
{
    std::vector<VolumeProblem> problems;
    std::set<QString> equal;
    std::vector<SliceSpan> ofEqual;
    std::set<QString> contradicting;
    std::vector<SliceSpan> ofContradicting;
    QStringList names;
    int slice = 0;
    for (SlicePlace& place : places) {
        ++slice;
        std::vector<ImageHeader> kept;
        for (ImageHeader& image : place.images) {
            const auto twin = std::find_if(kept.begin(), kept.end(), [&](const ImageHeader& other) {
                if (image.sopInstanceUid != other.sopInstanceUid || image.frame != other.frame)
                    return false;
                return !image.sopInstanceUid.isEmpty() || contents.areEqual(image.file, other.file);
            });
            if (twin == kept.end()) {
                kept.push_back(std::move(image));
                continue;
            }
            if (contents.areEqual(image.file, twin->file)) {
                equal.insert(image.file);
                ofEqual.push_back({.first = slice, .last = slice});
            } else {
                if (contradicting.insert(image.file).second)
                    names.append(QFileInfo(image.file).fileName());
                ofContradicting.push_back({.first = slice, .last = slice});
            }
        }
        place.images = std::move(kept);
    }
    if (!equal.empty()) {
        problems.push_back({.kind = VolumeProblem::Kind::DuplicateSlices,
            .said = {ProblemCode::DuplicatesLeftOut,
                {std::int64_t(equal.size()), slicesInWords(ofEqual)}},
            .slices = ofEqual});
    }
    if (!contradicting.empty()) {
        problems.push_back({.kind = VolumeProblem::Kind::DuplicateSlices,
            .said = {ProblemCode::ContradictingLeftOut,
                {namesIn(names), slicesInWords(ofContradicting)}},
            .caution = true,
            .slices = ofContradicting});
    }
    return problems;
}

} // namespace core
