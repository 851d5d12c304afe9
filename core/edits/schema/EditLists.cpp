// SPDX-License-Identifier: Apache-2.0
#include "core/edits/schema/EditLists.h"

#include "core/edits/fields/Quantum.h"
#include "core/edits/schema/EntryLists.h"

#include <QJsonArray>

#include <algorithm>

namespace core::editFields {

namespace {

constexpr int maxListLength = 1000000;
constexpr int maxOutlineLength = 100000;
constexpr int maxClipHalfSpaces = 16;

const Number sampleMillimetres{"mm", -quantum::reachMm, quantum::reachMm, quantum::perMillimetre};
const Number sideNormal{"", -1.0, 1.0, quantum::perDirection};
const Number samplePressure{"", 0.0, 1.0, quantum::perPressure};
const Number sampleSeconds{"s", 0.0, 86400.0, quantum::perSecond};

Clause checkLength(std::size_t length)
{
    if (length == 0)
        return Clause::saying("needs at least one entry");
    if (length > std::size_t(maxListLength))
        return Clause::saying("has more than %1 entries", maxListLength);
    return {};
}

} // namespace

QJsonValue PointList::write(const Value& value) const
{
    return writeEach(value, [this](const glm::dvec3& entry) { return point.write(entry); });
}

Clause PointList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of points [x, y, z]"),
        [this](const QJsonValue& each, glm::dvec3& entry) { return point.read(each, entry); });
}

Clause PointList::check(const Value& value) const
{
    if (value.empty() && mayBeEmpty)
        return {};
    if (const Clause reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    return checkEach(value, [this](const glm::dvec3& entry) { return point.check(entry); });
}

PointList::Value PointList::rounded(const Value& value) const
{
    return roundEach(value, [this](const glm::dvec3& entry) { return point.rounded(entry); });
}

QJsonValue ContourList::write(const Value& value) const
{
    return writeEach(
        value, [this](const PointList::Value& contour) { return PointList{point}.write(contour); });
}

Clause ContourList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of contours [[x, y, z], …]"),
        [this](const QJsonValue& each, PointList::Value& contour) {
            return PointList{point}.read(each, contour);
        });
}

Clause ContourList::check(const Value& value) const
{
    if (const Clause reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    return checkEach(value, [this](const PointList::Value& contour) {
        return contour.size() < 3 ? Clause::saying("needs at least three points")
                                  : PointList{point}.check(contour);
    });
}

ContourList::Value ContourList::rounded(const Value& value) const
{
    return roundEach(value,
        [this](const PointList::Value& contour) { return PointList{point}.rounded(contour); });
}

QJsonValue Outline::write(const Value& value) const
{
    return writeEach(value, [](const glm::dvec2& point) { return QJsonArray{point.x, point.y}; });
}

Clause Outline::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of points [x, y]"),
        [](const QJsonValue& each, glm::dvec2& point) { return readNumbers(each, &point.x, 2); });
}

Clause Outline::check(const Value& value) const
{
    if (value.size() < fewest)
        return fewest == 3 ? Clause::saying("needs at least three points")
                           : Clause::saying("needs at least %1 points", fewest);
    if (value.size() > std::size_t(maxOutlineLength))
        return Clause::saying("has more than %1 points", maxOutlineLength);
    return checkEach(value, [this](const glm::dvec2& point) {
        return firstOf({component.check(point.x), component.check(point.y)});
    });
}

Outline::Value Outline::rounded(const Value& value) const
{
    return roundEach(value, [this](const glm::dvec2& point) {
        return glm::dvec2(component.rounded(point.x), component.rounded(point.y));
    });
}

QJsonValue ClipHalfSpaceList::write(const Value& value) const
{
    return writeEach(value, [](const ClipHalfSpace& side) {
        return QJsonArray{side.normalLps.x, side.normalLps.y, side.normalLps.z, side.offsetMm};
    });
}

Clause ClipHalfSpaceList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of planes [x, y, z, offset]"),
        [](const QJsonValue& each, ClipHalfSpace& side) {
            double numbers[4]{};
            const Clause reason = readNumbers(each, numbers, 4);
            side = {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
            return reason;
        });
}

Clause ClipHalfSpaceList::check(const Value& value) const
{
    if (value.empty() || value.size() > std::size_t(maxClipHalfSpaces))
        return Clause::saying("needs 1 to %1 entries", maxClipHalfSpaces);
    return checkEach(value, [](const ClipHalfSpace& side) {
        const bool pointsSomewhere = glm::length(side.normalLps) > 0.01;
        return firstOf({sideNormal.check(side.normalLps.x), sideNormal.check(side.normalLps.y),
            sideNormal.check(side.normalLps.z), sampleMillimetres.check(side.offsetMm),
            pointsSomewhere ? Clause() : Clause::saying("has no direction")});
    });
}

ClipHalfSpaceList::Value ClipHalfSpaceList::rounded(const Value& value) const
{
    return roundEach(value, [](const ClipHalfSpace& side) {
        return ClipHalfSpace{
            Point{sideNormal}.rounded(side.normalLps), sampleMillimetres.rounded(side.offsetMm)};
    });
}

QJsonValue SampleList::write(const Value& value) const
{
    return writeEach(value, [](const PenSample& sample) {
        return QJsonArray{sample.xMm, sample.yMm, sample.pressure, sample.tSeconds};
    });
}

Clause SampleList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of samples [x, y, pressure, t]"),
        [](const QJsonValue& each, PenSample& sample) {
            double numbers[4]{};
            const Clause reason = readNumbers(each, numbers, 4);
            sample = {.xMm = numbers[0],
                .yMm = numbers[1],
                .pressure = numbers[2],
                .tSeconds = numbers[3]};
            return reason;
        });
}

Clause SampleList::check(const Value& value) const
{
    if (const Clause reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    double earlier = 0.0;
    return checkEach(value, [&earlier](const PenSample& sample) {
        const bool runsOn = !(sample.tSeconds < earlier);
        earlier = sample.tSeconds;
        return firstOf({sampleMillimetres.check(sample.xMm), sampleMillimetres.check(sample.yMm),
            samplePressure.check(sample.pressure), sampleSeconds.check(sample.tSeconds),
            runsOn ? Clause() : Clause::saying("time runs backwards")});
    });
}

SampleList::Value SampleList::rounded(const Value& value) const
{
    return roundEach(value, [](const PenSample& sample) {
        return PenSample{.xMm = sampleMillimetres.rounded(sample.xMm),
            .yMm = sampleMillimetres.rounded(sample.yMm),
            .pressure = samplePressure.rounded(sample.pressure),
            .tSeconds = sampleSeconds.rounded(sample.tSeconds)};
    });
}

QJsonValue PressureList::write(const Value& value) const
{
    return writeEach(value, [](double pressure) { return QJsonValue(pressure); });
}

Clause PressureList::read(const QJsonValue& json, Value& value) const
{
    return readEach(json, value, Clause::saying("must be a list of pressures"),
        [](const QJsonValue& each, double& pressure) {
            return samplePressure.read(each, pressure);
        });
}

Clause PressureList::check(const Value& value) const
{
    if (const Clause reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    return checkEach(value, [](double pressure) { return samplePressure.check(pressure); });
}

PressureList::Value PressureList::rounded(const Value& value) const
{
    return roundEach(value, [](double pressure) { return samplePressure.rounded(pressure); });
}

QJsonValue RowList::write(const Value& value) const
{
    return writeEach(value, [](std::int64_t row) { return QJsonValue(qint64(row)); });
}

Clause RowList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return Clause::saying("must be a list of rows");
    value.clear();
    for (const QJsonValue& entry : json.toArray()) {
        std::int64_t row = 0;
        if (!Row().read(entry, row).isEmpty())
            return Clause::saying("must be numbers of rows, 1 or more");
        value.push_back(row);
    }
    return {};
}

Clause RowList::check(const Value& value) const
{
    if (const Clause reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    if (value.front() < 1)
        return Clause::saying("must be numbers of rows, 1 or more");
    return ascends(value) ? Clause() : Clause::saying("must ascend");
}

QJsonValue PlaceList::write(const Value& value) const
{
    return RowList().write(value);
}

Clause PlaceList::read(const QJsonValue& json, Value& value) const
{
    return RowList().read(json, value).isEmpty()
        ? Clause()
        : Clause::saying("must be a list of places, whole numbers from 1 on");
}

Clause PlaceList::check(const Value& value) const
{
    if (value.empty())
        return {};
    return RowList().check(value).isEmpty() ? Clause() : Clause::saying("must ascend, from 1 on");
}

QJsonValue CornerPair::write(const Value& value) const
{
    return PointList{point}.write({value.fromLps, value.toLps});
}

Clause CornerPair::read(const QJsonValue& json, Value& value) const
{
    PointList::Value corners;
    if (const Clause reason = PointList{point}.read(json, corners); !reason.isEmpty())
        return reason;
    if (corners.size() != 2)
        return Clause::saying("must be two points [x, y, z]");
    value = {.fromLps = corners.front(), .toLps = corners.back()};
    return {};
}

Clause CornerPair::check(const Value& value) const
{
    return PointList{point}.check({value.fromLps, value.toLps});
}

CornerPair::Value CornerPair::rounded(const Value& value) const
{
    return {.fromLps = point.rounded(value.fromLps), .toLps = point.rounded(value.toLps)};
}

QJsonValue SegmentList::write(const Value& value) const
{
    return writeEach(value, [](int segment) { return segment; });
}

Clause SegmentList::read(const QJsonValue& json, Value& value) const
{
    if (mayBeEmpty && json.isArray() && json.toArray().isEmpty()) {
        value.clear();
        return {};
    }
    RowList::Value numbers;
    if (!RowList().read(json, numbers).isEmpty())
        return Clause::saying("must be a list of segments, whole numbers from 1 on");
    value.clear();
    for (const std::int64_t number : numbers)
        value.push_back(int(std::min<std::int64_t>(number, 256))); // check() refuses that
    return {};
}

Clause SegmentList::check(const Value& value) const
{
    if (mayBeEmpty && value.empty())
        return {};
    if (const Clause reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    if (value.front() < 1 || value.back() > 255)
        return Clause::saying("must be numbers of segments, 1 … 255");
    return ascends(value) ? Clause() : Clause::saying("must ascend");
}

} // namespace core::editFields
