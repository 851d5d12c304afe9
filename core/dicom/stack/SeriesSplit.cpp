// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/SeriesSplit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace core {

namespace {

using Images = std::vector<ImageHeader>;

bool near(const glm::dvec3& a, const glm::dvec3& b)
{
    constexpr double tolerance = 1e-4;
    return std::abs(a.x - b.x) < tolerance && std::abs(a.y - b.y) < tolerance
        && std::abs(a.z - b.z) < tolerance;
}

bool near(double a, double b)
{
    return std::abs(a - b) <= 1e-4 * std::max(std::abs(a), std::abs(b));
}

bool sameGrid(const ImageHeader& a, const ImageHeader& b)
{
    return a.layout.floatBits == b.layout.floatBits && a.layout.isWide() == b.layout.isWide()
        && a.layout.rows == b.layout.rows && a.layout.columns == b.layout.columns
        && near(a.spacing->x, b.spacing->x) && near(a.spacing->y, b.spacing->y)
        && near(a.plane->row, b.plane->row) && near(a.plane->column, b.plane->column);
}

std::vector<Images> splitByGrid(Images images)
{
    std::vector<Images> groups;
    for (ImageHeader& image : images) {
        const auto found = std::find_if(groups.begin(), groups.end(),
            [&](const Images& group) { return sameGrid(group.front(), image); });
        if (found != groups.end())
            found->push_back(std::move(image));
        else
            groups.emplace_back().push_back(std::move(image));
    }
    return groups;
}

/// A stack is one of its file's, or of files that follow each other in time.
std::vector<Images> splitByFrameOfReference(Images group)
{
    const bool meaningless = framesOfReferenceAreMeaningless(group);
    std::map<std::pair<QString, QString>, Images> byFrame;
    for (ImageHeader& image : group) {
        const QString frame = meaningless ? QString() : image.identity.frameOfReferenceUid;
        byFrame[{frame, image.stackId}].push_back(std::move(image));
    }
    std::vector<Images> groups;
    for (auto& [key, images] : byFrame)
        groups.push_back(std::move(images));
    return groups;
}

} // namespace

bool framesOfReferenceAreMeaningless(const std::vector<ImageHeader>& slices)
{
    std::set<QString> frames;
    for (const ImageHeader& image : slices)
        frames.insert(image.identity.frameOfReferenceUid);
    return frames.size() > 1 && frames.size() == slices.size();
}

std::vector<std::vector<ImageHeader>> splitSeries(std::vector<ImageHeader> slices)
{
    std::vector<Images> all;
    for (Images& grid : splitByGrid(std::move(slices))) {
        for (Images& group : splitByFrameOfReference(std::move(grid)))
            all.push_back(std::move(group));
    }
    return all;
}

} // namespace core
