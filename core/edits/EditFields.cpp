// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditFields.h"

#include "core/edits/EditQuantise.h"
#include "core/growth/SeedWord.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <functional>

namespace core::editFields {

namespace {

constexpr int maxListLength = 1000000;
constexpr int maxOutlineLength = 100000;
constexpr int maxTextLength = 256;
constexpr int maxHiddenSides = 16;

const Number sampleMillimetres{"mm", -quantum::reachMm, quantum::reachMm, quantum::perMillimetre};
const Number sideNormal{"", -1.0, 1.0, quantum::perDirection};
const Number samplePressure{"", 0.0, 1.0, quantum::perPressure};
const Number sampleSeconds{"s", 0.0, 86400.0, quantum::perSecond};

QString at(int position, const QString& reason)
{
    return QStringLiteral("entry %1: %2").arg(position + 1).arg(reason);
}

QString readNumbers(const QJsonValue& json, double* numbers, int count)
{
    const QJsonArray array = json.toArray();
    if (!json.isArray() || array.size() != count)
        return QStringLiteral("must be a list of %1 numbers").arg(count);
    for (int i = 0; i < count; ++i) {
        if (!array[i].isDouble())
            return QStringLiteral("must be a list of %1 numbers").arg(count);
        numbers[i] = array[i].toDouble();
    }
    return {};
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

// --- Number
// ------------------------------------------------------------------------------------------

QString Number::type() const
{
    if (maximum >= quantum::unbounded)
        return QStringLiteral("number");
    return QStringLiteral("number %1 … %2").arg(minimum).arg(maximum);
}

QString Number::unit() const
{
    return QLatin1String(unitName);
}

QJsonValue Number::write(Value value) const
{
    return value;
}

QString Number::read(const QJsonValue& json, Value& value) const
{
    if (!json.isDouble())
        return QStringLiteral("must be a number");
    value = json.toDouble();
    return {};
}

QString Number::check(Value value) const
{
    if (!std::isfinite(value))
        return QStringLiteral("must be a finite number");
    if (value < minimum || value > maximum)
        return QStringLiteral("%1 is outside %2 … %3").arg(value).arg(minimum).arg(maximum);
    return {};
}

double Number::rounded(Value value) const
{
    if (stepsPerUnit != 0.0) {
        double steps = std::round(value * stepsPerUnit);
        // The ends of a range need not lie on the grid; an allowed value stays allowed.
        if (steps / stepsPerUnit < minimum && value >= minimum)
            steps += 1.0;
        if (steps / stepsPerUnit > maximum && value <= maximum)
            steps -= 1.0;
        value = steps / stepsPerUnit;
    }
    // Adding zero turns −0 into 0, so that equal values have one written form.
    return value + 0.0;
}

// --- WholeNumber, Flag
// -------------------------------------------------------------------------------

QString WholeNumber::type() const
{
    if (minimum == maximum)
        return QString::number(minimum);
    return QStringLiteral("whole number %1 … %2").arg(minimum).arg(maximum);
}

QString WholeNumber::read(const QJsonValue& json, Value& value) const
{
    const double number = json.toDouble();
    if (!json.isDouble() || number != std::floor(number) || std::abs(number) > 2e9)
        return QStringLiteral("must be a whole number");
    value = int(number);
    return {};
}

QString WholeNumber::check(Value value) const
{
    if (value >= minimum && value <= maximum)
        return {};
    if (minimum == maximum)
        return QStringLiteral("%1 is not supported, only %2").arg(value).arg(minimum);
    return QStringLiteral("%1 is outside %2 … %3").arg(value).arg(minimum).arg(maximum);
}

QString Flag::read(const QJsonValue& json, Value& value) const
{
    if (!json.isBool())
        return QStringLiteral("must be true or false");
    value = json.toBool();
    return {};
}

// --- Text, Colour, Code
// ------------------------------------------------------------------------------

QString Text::read(const QJsonValue& json, Value& value) const
{
    if (!json.isString())
        return QStringLiteral("must be a text");
    value = json.toString();
    return {};
}

QString Text::check(const Value& value) const
{
    if (value.trimmed().isEmpty())
        return QStringLiteral("must not be empty");
    if (value.size() > maxTextLength)
        return QStringLiteral("is longer than %1 characters").arg(maxTextLength);
    for (const QChar character : value) {
        if (character.category() == QChar::Other_Control)
            return QStringLiteral("must not contain control characters");
    }
    if (!value.isValidUtf16())
        return QStringLiteral("is not valid Unicode");
    return {};
}

QJsonValue Colour::write(Value value) const
{
    return QStringLiteral("#%1").arg(value, 6, 16, QLatin1Char('0'));
}

QString Colour::read(const QJsonValue& json, Value& value) const
{
    const QString text = json.toString();
    bool isHex = json.isString() && text.size() == 7 && text.startsWith(QLatin1Char('#'));
    for (qsizetype i = 1; isHex && i < text.size(); ++i)
        isHex = QStringLiteral("0123456789abcdefABCDEF").contains(text[i]);
    if (!isHex)
        return QStringLiteral("must be a colour like \"#e0c068\"");
    value = text.mid(1).toUInt(nullptr, 16);
    return {};
}

QString Colour::check(Value value) const
{
    return value <= 0xFFFFFFu ? QString() : QStringLiteral("is not a 24-bit colour");
}

QJsonValue Code::write(const Value& value) const
{
    return value.isSet() ? QJsonArray{value.scheme, value.value, value.meaning} : QJsonArray();
}

QString Code::read(const QJsonValue& json, Value& value) const
{
    const QJsonArray array = json.toArray();
    bool wellFormed = json.isArray() && (array.isEmpty() || array.size() == 3);
    for (const QJsonValue& part : array)
        wellFormed = wellFormed && part.isString();
    if (!wellFormed)
        return QStringLiteral("must be [scheme, value, meaning], three texts, or []");
    value = {array.at(0).toString(), array.at(1).toString(), array.at(2).toString()};
    return array.isEmpty() ? QString() : check(value);
}

QString Code::check(const Value& value) const
{
    if (value == Value())
        return {};
    // DICOM PS3.5 6.2: SH has at most 16 characters, LO at most 64, and a backslash separates
    // values.
    struct Part {
        const char* name;
        const QString& text;
        int maxLength;
    };
    for (const Part& part : {Part{"scheme", value.scheme, 16}, Part{"value", value.value, 16},
             Part{"meaning", value.meaning, 64}}) {
        const QString name = QLatin1String(part.name);
        if (const QString reason = Text().check(part.text); !reason.isEmpty())
            return QStringLiteral("%1 %2").arg(name, reason);
        if (part.text.size() > part.maxLength)
            return QStringLiteral("%1 is longer than %2 characters").arg(name).arg(part.maxLength);
        if (part.text.contains(QLatin1Char('\\')))
            return QStringLiteral("%1 must not contain a backslash").arg(name);
    }
    return {};
}

// --- Point, PointList, SampleList
// --------------------------------------------------------------------

QJsonValue Point::write(const Value& value) const
{
    return QJsonArray{value.x, value.y, value.z};
}

QString Point::read(const QJsonValue& json, Value& value) const
{
    return readNumbers(json, &value.x, 3);
}

QString Point::check(const Value& value) const
{
    for (int axis = 0; axis < 3; ++axis) {
        if (const QString reason = component.check(value[axis]); !reason.isEmpty())
            return reason;
    }
    return {};
}

glm::dvec3 Point::rounded(const Value& value) const
{
    return {component.rounded(value.x), component.rounded(value.y), component.rounded(value.z)};
}

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

// --- Outline
// -------------------------------------------------------------------------------------------

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

// --- HiddenSideList
// ------------------------------------------------------------------------------------

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

// --- BrushShape
// ------------------------------------------------------------------------------------------

QJsonValue BrushShape::write(Value value) const
{
    return value == Value::Disc ? QStringLiteral("disc") : QStringLiteral("ball");
}

QString BrushShape::read(const QJsonValue& json, Value& value) const
{
    const QString text = json.toString();
    if (text != QLatin1String("ball") && text != QLatin1String("disc"))
        return QStringLiteral("must be \"ball\" or \"disc\"");
    value = text == QLatin1String("disc") ? Value::Disc : Value::Ball;
    return {};
}

// --- Row
// -------------------------------------------------------------------------------------------------

QString Row::read(const QJsonValue& json, Value& value) const
{
    const double number = json.toDouble(-1.0);
    if (number < 1.0 || number > 1e15 || number != std::floor(number))
        return QStringLiteral("must be the number of a row, 1 or more");
    value = std::int64_t(number);
    return {};
}
QString Row::check(Value value) const
{
    return value < 1 ? QStringLiteral("must be the number of a row, 1 or more") : QString();
}

// --- RowList
// --------------------------------------------------------------------

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

// --- PlaceList
// --------------------------------------------------------------------

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

// --- StepCount
// ---------------------------------------------------------------------------------------

QJsonValue StepCount::write(const Value& value) const
{
    return value ? QJsonValue(*value) : QJsonValue(QStringLiteral("toClosure"));
}

QString StepCount::read(const QJsonValue& json, Value& value) const
{
    if (json.isString() && json.toString() == QLatin1String("toClosure")) {
        value.reset();
        return {};
    }
    int count = 0;
    if (!WholeNumber{0, 0}.read(json, count).isEmpty())
        return QStringLiteral("must be a whole number or \"toClosure\"");
    value = count;
    return {};
}

QString StepCount::check(const Value& value) const
{
    return value ? WholeNumber{0, int(seedWord::maxGeneration)}.check(*value) : QString();
}

} // namespace core::editFields
