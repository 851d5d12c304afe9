// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/TimePoints.h"

#include "core/dicom/base/DicomText.h"
#include "core/dicom/header/PhaseAttributes.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace core {

namespace {

/// Values of the attributes that name a point; of the first alone, or of two.
using Value = std::pair<QString, QString>;

struct Attributes {
    std::size_t first = 0;
    std::size_t second = 0; ///< the same: only one

    [[nodiscard]] Value of(const ImageHeader& image) const
    {
        return {image.phases.at(first), first == second ? QString() : image.phases.at(second)};
    }
    [[nodiscard]] bool told(const ImageHeader& image) const
    {
        return !image.phases.at(first).isEmpty() && !image.phases.at(second).isEmpty();
    }
    [[nodiscard]] bool haveOrder() const { return phaseHasOrder(first) && phaseHasOrder(second); }
    [[nodiscard]] Clause text(const Value& value) const
    {
        const Clause text = phaseText(first, value.first);
        return first == second ? text
                               : Clause::saying("%1, %2", text, phaseText(second, value.second));
    }
};

int compare(const QString& a, const QString& b)
{
    const QByteArray first = a.toLatin1();
    const QByteArray second = b.toLatin1();
    const std::optional<double> x = dicomNumber({first.constData(), std::size_t(first.size())});
    const std::optional<double> y = dicomNumber({second.constData(), std::size_t(second.size())});
    if (x && y && *x != *y)
        return *x < *y ? -1 : 1;
    return a.compare(b);
}

bool lessValue(const Value& a, const Value& b)
{
    const int first = compare(a.first, b.first);
    return first != 0 ? first < 0 : compare(a.second, b.second) < 0;
}

bool comesFirst(const ImageHeader& a, const ImageHeader& b)
{
    return std::tie(a.instanceNumber, a.file, a.frame)
        < std::tie(b.instanceNumber, b.file, b.frame);
}

std::size_t mostImages(const std::vector<SlicePlace>& places)
{
    std::size_t most = 0;
    for (const SlicePlace& place : places)
        most = std::max(most, place.images.size());
    return most;
}

/// The values of attributes that tell the images of every place apart; none if they do not.
std::optional<std::vector<Value>> tellingValues(
    const std::vector<SlicePlace>& places, const Attributes& attributes, std::size_t most)
{
    std::set<Value> all;
    for (const SlicePlace& place : places) {
        std::set<Value> here;
        for (const ImageHeader& image : place.images) {
            if (!attributes.told(image) || !here.insert(attributes.of(image)).second)
                return std::nullopt;
        }
        all.insert(here.begin(), here.end());
        if (all.size() > most)
            return std::nullopt;
    }
    if (all.size() != most)
        return std::nullopt;
    std::vector<Value> values(all.begin(), all.end());
    std::sort(values.begin(), values.end(), lessValue);
    return values;
}

bool byValue(std::vector<SlicePlace>& places, const Attributes& attributes, TimeAxis& axis)
{
    const auto values = tellingValues(places, attributes, mostImages(places));
    if (!values)
        return false;
    std::map<Value, std::size_t> points;
    for (const Value& value : *values) {
        points.emplace(value, axis.points.size());
        axis.points.push_back({.label = attributes.text(value)});
    }
    for (SlicePlace& place : places) {
        for (ImageHeader& image : place.images)
            axis.points[points.at(attributes.of(image))].slices.push_back(std::move(image));
    }
    if (!attributes.haveOrder()) {
        std::sort(
            axis.points.begin(), axis.points.end(), [](const TimePoint& a, const TimePoint& b) {
                return comesFirst(a.slices.front(), b.slices.front());
            });
    }
    axis.certain = true;
    return true;
}

bool byOneOrTwo(std::vector<SlicePlace>& places, TimeAxis& axis)
{
    const std::size_t count = phaseAttributeCount();
    for (std::size_t one = 0; one < count; ++one) {
        if (byValue(places, {one, one}, axis))
            return true;
    }
    for (std::size_t first = 0; first < count; ++first) {
        for (std::size_t second = first + 1; second < count; ++second) {
            if (byValue(places, {first, second}, axis))
                return true;
        }
    }
    return false;
}

void byNumber(std::vector<SlicePlace>& places, TimeAxis& axis)
{
    axis.points.resize(mostImages(places));
    for (SlicePlace& place : places) {
        std::stable_sort(place.images.begin(), place.images.end(), comesFirst);
        for (std::size_t point = 0; point < place.images.size(); ++point)
            axis.points[point].slices.push_back(std::move(place.images[point]));
    }
    axis.certain = true;
    int reached = INT32_MIN;
    for (const TimePoint& point : axis.points) {
        const auto [least, greatest] = std::minmax_element(point.slices.begin(), point.slices.end(),
            [](const ImageHeader& a, const ImageHeader& b) {
                return a.instanceNumber < b.instanceNumber;
            });
        axis.certain = axis.certain && least->instanceNumber > reached;
        reached = greatest->instanceNumber;
    }
}

/// Images beside each other are no points in time.
bool lieOnEachOther(const SlicePlace& place)
{
    const ImageHeader& first = place.images.front();
    const double pixel = std::min(first.spacing->x, first.spacing->y);
    return std::all_of(place.images.begin(), place.images.end(), [&](const ImageHeader& image) {
        return glm::distance(*image.position, *first.position) < 0.5 * pixel;
    });
}

} // namespace

TimeAxis findTimeAxis(std::vector<SlicePlace> places)
{
    TimeAxis axis;
    const std::size_t most = mostImages(places);
    axis.complete = std::all_of(places.begin(), places.end(), [&](const SlicePlace& place) {
        return place.images.size() == most && lieOnEachOther(place);
    });
    if (!byOneOrTwo(places, axis))
        byNumber(places, axis);
    return axis;
}

} // namespace core
