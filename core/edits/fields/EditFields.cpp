// SPDX-License-Identifier: Apache-2.0
#include "core/edits/fields/EditFields.h"

#include "core/edits/fields/Quantum.h"
#include "core/growth/SeedWord.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace core::editFields {

namespace {

constexpr int maxTextLength = 256;

} // namespace

Clause readNumbers(const QJsonValue& json, double* numbers, int count)
{
    const QJsonArray array = json.toArray();
    if (!json.isArray() || array.size() != count)
        return Clause::saying("must be a list of %1 numbers", count);
    for (int i = 0; i < count; ++i) {
        if (!array[i].isDouble())
            return Clause::saying("must be a list of %1 numbers", count);
        numbers[i] = array[i].toDouble();
    }
    return {};
}

QString Number::type() const
{
    if (maximum >= quantum::unbounded)
        return QStringLiteral("number");
    return QStringLiteral("number %1 … %2").arg(minimum).arg(maximum);
}

QString Number::unit() const
{
    return QString::fromUtf8(unitName);
}

QJsonValue Number::write(Value value) const
{
    return value;
}

Clause Number::read(const QJsonValue& json, Value& value) const
{
    if (!json.isDouble())
        return Clause::saying("must be a number");
    value = json.toDouble();
    return {};
}

Clause Number::check(Value value) const
{
    if (!std::isfinite(value))
        return Clause::saying("must be a finite number");
    if (value < minimum || value > maximum)
        return Clause::saying("%1 is outside %2 … %3", value, minimum, maximum);
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

QString WholeNumber::type() const
{
    if (minimum == maximum)
        return QString::number(minimum);
    return QStringLiteral("whole number %1 … %2").arg(minimum).arg(maximum);
}

Clause WholeNumber::read(const QJsonValue& json, Value& value) const
{
    const double number = json.toDouble();
    if (!json.isDouble() || number != std::floor(number) || std::abs(number) > 2e9)
        return Clause::saying("must be a whole number");
    value = int(number);
    return {};
}

Clause WholeNumber::check(Value value) const
{
    if (value >= minimum && value <= maximum)
        return {};
    if (minimum == maximum)
        return Clause::saying("%1 is not supported, only %2", value, minimum);
    return Clause::saying("%1 is outside %2 … %3", value, minimum, maximum);
}

Clause Connectivity::read(const QJsonValue& json, Value& value) const
{
    return WholeNumber{6, 26}.read(json, value);
}

Clause Connectivity::check(Value value) const
{
    if (value == 6 || value == 18 || value == 26)
        return {};
    return Clause::saying("%1 is not supported, only 6, 18 and 26", value);
}

Clause Flag::read(const QJsonValue& json, Value& value) const
{
    if (!json.isBool())
        return Clause::saying("must be true or false");
    value = json.toBool();
    return {};
}

Clause Text::read(const QJsonValue& json, Value& value) const
{
    if (!json.isString())
        return Clause::saying("must be a text");
    value = json.toString();
    return {};
}

Clause Text::check(const Value& value) const
{
    if (value.trimmed().isEmpty())
        return Clause::saying("must not be empty");
    if (value.size() > maxTextLength)
        return Clause::saying("is longer than %1 characters", maxTextLength);
    for (const QChar character : value) {
        if (character.category() == QChar::Other_Control)
            return Clause::saying("must not contain control characters");
    }
    if (!value.isValidUtf16())
        return Clause::saying("is not valid Unicode");
    return {};
}

QJsonValue Colour::write(Value value) const
{
    return QStringLiteral("#%1").arg(value, 6, 16, QLatin1Char('0'));
}

Clause Colour::read(const QJsonValue& json, Value& value) const
{
    const QString text = json.toString();
    bool isHex = json.isString() && text.size() == 7 && text.startsWith(QLatin1Char('#'));
    for (qsizetype i = 1; isHex && i < text.size(); ++i)
        isHex = QStringLiteral("0123456789abcdefABCDEF").contains(text[i]);
    if (!isHex)
        return Clause::saying("must be a colour like \"#e0c068\"");
    value = text.mid(1).toUInt(nullptr, 16);
    return {};
}

Clause Colour::check(Value value) const
{
    return value <= 0xFFFFFFu ? Clause() : Clause::saying("is not a 24-bit colour");
}

QJsonValue Code::write(const Value& value) const
{
    return value.isSet() ? QJsonArray{value.scheme, value.value, value.meaning} : QJsonArray();
}

Clause Code::read(const QJsonValue& json, Value& value) const
{
    const QJsonArray array = json.toArray();
    bool wellFormed = json.isArray() && (array.isEmpty() || array.size() == 3);
    for (const QJsonValue& part : array)
        wellFormed = wellFormed && part.isString();
    if (!wellFormed)
        return Clause::saying("must be [scheme, value, meaning], three texts, or []");
    value = {array.at(0).toString(), array.at(1).toString(), array.at(2).toString()};
    return array.isEmpty() ? Clause() : check(value);
}

Clause Code::check(const Value& value) const
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
        if (const Clause reason = Text().check(part.text); !reason.isEmpty())
            return Clause::saying("%1 %2", name, reason);
        if (part.text.size() > part.maxLength)
            return Clause::saying("%1 is longer than %2 characters", name, part.maxLength);
        if (part.text.contains(QLatin1Char('\\')))
            return Clause::saying("%1 must not contain a backslash", name);
    }
    return {};
}

QJsonValue Point::write(const Value& value) const
{
    return QJsonArray{value.x, value.y, value.z};
}

Clause Point::read(const QJsonValue& json, Value& value) const
{
    return readNumbers(json, &value.x, 3);
}

Clause Point::check(const Value& value) const
{
    for (int axis = 0; axis < 3; ++axis) {
        if (const Clause reason = component.check(value[axis]); !reason.isEmpty())
            return reason;
    }
    return {};
}

glm::dvec3 Point::rounded(const Value& value) const
{
    return {component.rounded(value.x), component.rounded(value.y), component.rounded(value.z)};
}

Clause Row::read(const QJsonValue& json, Value& value) const
{
    const double number = json.toDouble(-1.0);
    if (number < 1.0 || number > 1e15 || number != std::floor(number))
        return Clause::saying("must be the number of a row, 1 or more");
    value = std::int64_t(number);
    return {};
}

Clause Row::check(Value value) const
{
    return value < 1 ? Clause::saying("must be the number of a row, 1 or more") : Clause();
}

QString StepCount::type() const
{
    return QStringLiteral("whole number or \"%1\"").arg(QLatin1String(all));
}

QJsonValue StepCount::write(const Value& value) const
{
    return value ? QJsonValue(*value) : QJsonValue(QLatin1String(all));
}

Clause StepCount::read(const QJsonValue& json, Value& value) const
{
    if (json.isString() && json.toString() == QLatin1String(all)) {
        value.reset();
        return {};
    }
    int count = 0;
    if (!WholeNumber{0, 0}.read(json, count).isEmpty())
        return Clause::saying("must be a whole number or \"%1\"", QLatin1String(all));
    value = count;
    return {};
}

Clause StepCount::check(const Value& value) const
{
    return value ? WholeNumber{0, int(seedWord::maxGeneration)}.check(*value) : Clause();
}

} // namespace core::editFields
