// SPDX-License-Identifier: Apache-2.0
#include "core/edits/schema/EditLists.h"

#include "core/edits/fields/Quantum.h"

#include <QJsonArray>

#include <algorithm>
#include <functional>

namespace core::editFields {

namespace {

constexpr int maxListLength = 1000000;
constexpr int maxOutlineLength = 100000;
constexpr int maxHiddenSides = 16;

const Number sampleMillimetres{"mm", -quantum::reachMm, quantum::reachMm, quantum::perMillimetre};
const Number sideNormal{"", -1.0, 1.0, quantum::perDirection};
const Number samplePressure{"", 0.0, 1.0, quantum::perPressure};
const Number sampleSeconds{"s", 0.0, 86400.0, quantum::perSecond};

QString at(int position, const QString& reason)
{
    return QStringLiteral("entry %1: %2").arg(position + 1).arg(reason);
}

QString checkLength(std::size_t length)
{
    if (length == 0)
        return QStringLiteral("needs at least one entry");
    if (length > std::size_t(maxListLength))
        return QStringLiteral("has more than %1 entries").arg(maxListLength);
    return {};
}

} // namespace

QJsonValue PointList::write(const Value& value) const
{
    QJsonArray array;
    for (const glm::dvec3& entry : value)
        array.append(point.write(entry));
    return array;
}

QString PointList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of points [x, y, z]");
    const QJsonArray array = json.toArray();
    value.assign(std::size_t(array.size()), glm::dvec3(0.0));
    for (int i = 0; i < array.size(); ++i) {
        if (const QString reason = point.read(array[i], value[std::size_t(i)]); !reason.isEmpty())
            return at(i, reason);
    }
    return {};
}

QString PointList::check(const Value& value) const
{
    if (value.empty() && mayBeEmpty)
        return {};
    if (const QString reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (const QString reason = point.check(value[i]); !reason.isEmpty())
            return at(int(i), reason);
    }
    return {};
}

PointList::Value PointList::rounded(const Value& value) const
{
    Value result;
    result.reserve(value.size());
    for (const glm::dvec3& entry : value)
        result.push_back(point.rounded(entry));
    return result;
}

QJsonValue ContourList::write(const Value& value) const
{
    QJsonArray array;
    for (const std::vector<glm::dvec3>& contour : value)
        array.append(PointList{point}.write(contour));
    return array;
}

QString ContourList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of contours [[x, y, z], …]");
    const QJsonArray array = json.toArray();
    value.assign(std::size_t(array.size()), {});
    for (int i = 0; i < array.size(); ++i) {
        if (const QString reason = PointList{point}.read(array[i], value[std::size_t(i)]);
            !reason.isEmpty())
            return at(i, reason);
    }
    return {};
}

QString ContourList::check(const Value& value) const
{
    if (const QString reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (value[i].size() < 3)
            return at(int(i), QStringLiteral("needs at least three points"));
        if (const QString reason = PointList{point}.check(value[i]); !reason.isEmpty())
            return at(int(i), reason);
    }
    return {};
}

ContourList::Value ContourList::rounded(const Value& value) const
{
    Value result;
    for (const std::vector<glm::dvec3>& contour : value)
        result.push_back(PointList{point}.rounded(contour));
    return result;
}

QJsonValue Outline::write(const Value& value) const
{
    QJsonArray array;
    for (const glm::dvec2& point : value)
        array.append(QJsonArray{point.x, point.y});
    return array;
}

QString Outline::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of points [x, y]");
    const QJsonArray array = json.toArray();
    value.assign(std::size_t(array.size()), glm::dvec2(0.0));
    for (int i = 0; i < array.size(); ++i) {
        if (const QString reason = readNumbers(array[i], &value[std::size_t(i)].x, 2);
            !reason.isEmpty())
            return at(i, reason);
    }
    return {};
}

QString Outline::check(const Value& value) const
{
    if (value.size() < 3)
        return QStringLiteral("needs at least three points");
    if (value.size() > std::size_t(maxOutlineLength))
        return QStringLiteral("has more than %1 points").arg(maxOutlineLength);
    for (std::size_t i = 0; i < value.size(); ++i) {
        for (const double number : {value[i].x, value[i].y}) {
            if (const QString reason = component.check(number); !reason.isEmpty())
                return at(int(i), reason);
        }
    }
    return {};
}

Outline::Value Outline::rounded(const Value& value) const
{
    Value result;
    result.reserve(value.size());
    for (const glm::dvec2& point : value)
        result.emplace_back(component.rounded(point.x), component.rounded(point.y));
    return result;
}

QJsonValue HiddenSideList::write(const Value& value) const
{
    QJsonArray array;
    for (const HiddenSide& side : value)
        array.append(
            QJsonArray{side.normalLps.x, side.normalLps.y, side.normalLps.z, side.offsetMm});
    return array;
}

QString HiddenSideList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of planes [x, y, z, offset]");
    const QJsonArray array = json.toArray();
    value.clear();
    for (int i = 0; i < array.size(); ++i) {
        double numbers[4]{};
        if (const QString reason = readNumbers(array[i], numbers, 4); !reason.isEmpty())
            return at(i, reason);
        value.push_back({{numbers[0], numbers[1], numbers[2]}, numbers[3]});
    }
    return {};
}

QString HiddenSideList::check(const Value& value) const
{
    if (value.empty() || value.size() > std::size_t(maxHiddenSides))
        return QStringLiteral("needs 1 to %1 entries").arg(maxHiddenSides);
    for (std::size_t i = 0; i < value.size(); ++i) {
        const HiddenSide& side = value[i];
        for (const QString& reason :
            {sideNormal.check(side.normalLps.x), sideNormal.check(side.normalLps.y),
                sideNormal.check(side.normalLps.z), sampleMillimetres.check(side.offsetMm)}) {
            if (!reason.isEmpty())
                return at(int(i), reason);
        }
        if (!(glm::length(side.normalLps) > 0.01))
            return at(int(i), QStringLiteral("has no direction"));
    }
    return {};
}

HiddenSideList::Value HiddenSideList::rounded(const Value& value) const
{
    Value result;
    for (const HiddenSide& side : value)
        result.push_back(
            {Point{sideNormal}.rounded(side.normalLps), sampleMillimetres.rounded(side.offsetMm)});
    return result;
}

QJsonValue SampleList::write(const Value& value) const
{
    QJsonArray array;
    for (const PenSample& sample : value)
        array.append(QJsonArray{sample.xMm, sample.yMm, sample.pressure, sample.tSeconds});
    return array;
}

QString SampleList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of samples [x, y, pressure, t]");
    const QJsonArray array = json.toArray();
    value.clear();
    value.reserve(std::size_t(array.size()));
    for (int i = 0; i < array.size(); ++i) {
        double numbers[4]{};
        if (const QString reason = readNumbers(array[i], numbers, 4); !reason.isEmpty())
            return at(i, reason);
        value.push_back(
            {.xMm = numbers[0], .yMm = numbers[1], .pressure = numbers[2], .tSeconds = numbers[3]});
    }
    return {};
}

QString SampleList::check(const Value& value) const
{
    if (const QString reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    double earlier = 0.0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const PenSample& sample = value[i];
        for (const QString& reason :
            {sampleMillimetres.check(sample.xMm), sampleMillimetres.check(sample.yMm),
                samplePressure.check(sample.pressure), sampleSeconds.check(sample.tSeconds)}) {
            if (!reason.isEmpty())
                return at(int(i), reason);
        }
        if (sample.tSeconds < earlier)
            return at(int(i), QStringLiteral("time runs backwards"));
        earlier = sample.tSeconds;
    }
    return {};
}

SampleList::Value SampleList::rounded(const Value& value) const
{
    Value result;
    result.reserve(value.size());
    for (const PenSample& sample : value) {
        result.push_back({.xMm = sampleMillimetres.rounded(sample.xMm),
            .yMm = sampleMillimetres.rounded(sample.yMm),
            .pressure = samplePressure.rounded(sample.pressure),
            .tSeconds = sampleSeconds.rounded(sample.tSeconds)});
    }
    return result;
}

QJsonValue RowList::write(const Value& value) const
{
    QJsonArray array;
    for (const std::int64_t row : value)
        array.append(qint64(row));
    return array;
}

QString RowList::read(const QJsonValue& json, Value& value) const
{
    if (!json.isArray())
        return QStringLiteral("must be a list of rows");
    value.clear();
    for (const QJsonValue& entry : json.toArray()) {
        std::int64_t row = 0;
        if (!Row().read(entry, row).isEmpty())
            return QStringLiteral("must be numbers of rows, 1 or more");
        value.push_back(row);
    }
    return {};
}

QString RowList::check(const Value& value) const
{
    if (const QString reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    if (value.front() < 1)
        return QStringLiteral("must be numbers of rows, 1 or more");
    if (std::adjacent_find(value.begin(), value.end(), std::greater_equal<>()) != value.end())
        return QStringLiteral("must ascend");
    return {};
}

QJsonValue PlaceList::write(const Value& value) const
{
    return RowList().write(value);
}

QString PlaceList::read(const QJsonValue& json, Value& value) const
{
    return RowList().read(json, value).isEmpty()
        ? QString()
        : QStringLiteral("must be a list of places, whole numbers from 1 on");
}

QString PlaceList::check(const Value& value) const
{
    if (value.empty())
        return {};
    return RowList().check(value).isEmpty() ? QString() : QStringLiteral("must ascend, from 1 on");
}

QJsonValue CornerPair::write(const Value& value) const
{
    return PointList{point}.write({value.fromLps, value.toLps});
}

QString CornerPair::read(const QJsonValue& json, Value& value) const
{
    PointList::Value corners;
    if (const QString reason = PointList{point}.read(json, corners); !reason.isEmpty())
        return reason;
    if (corners.size() != 2)
        return QStringLiteral("must be two points [x, y, z]");
    value = {.fromLps = corners.front(), .toLps = corners.back()};
    return {};
}

QString CornerPair::check(const Value& value) const
{
    return PointList{point}.check({value.fromLps, value.toLps});
}

CornerPair::Value CornerPair::rounded(const Value& value) const
{
    return {.fromLps = point.rounded(value.fromLps), .toLps = point.rounded(value.toLps)};
}

QJsonValue SegmentList::write(const Value& value) const
{
    QJsonArray array;
    for (const int segment : value)
        array.append(segment);
    return array;
}

QString SegmentList::read(const QJsonValue& json, Value& value) const
{
    RowList::Value numbers;
    if (!RowList().read(json, numbers).isEmpty())
        return QStringLiteral("must be a list of segments, whole numbers from 1 on");
    value.clear();
    for (const std::int64_t number : numbers)
        value.push_back(int(std::min<std::int64_t>(number, 256))); // check() refuses that
    return {};
}

QString SegmentList::check(const Value& value) const
{
    if (const QString reason = checkLength(value.size()); !reason.isEmpty())
        return reason;
    if (value.front() < 1 || value.back() > 255)
        return QStringLiteral("must be numbers of segments, 1 … 255");
    if (std::adjacent_find(value.begin(), value.end(), std::greater_equal<>()) != value.end())
        return QStringLiteral("must ascend");
    return {};
}

} // namespace core::editFields
