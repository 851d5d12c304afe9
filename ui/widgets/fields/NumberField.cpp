// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/fields/NumberField.h"

#include "ui/base/NumberText.h"

namespace ui {

namespace {

constexpr QLatin1Char hyphen('-'); // the only minus sign that Qt's fields know

/// Exchanges the sign of the number in a field's text. What stands before and after the number, and
/// a text that stands for a value, may hold hyphens that are none.
template <class Field> void exchangeSign(QString& text, const Field& field, QChar sign, QChar by)
{
    qsizetype place = text.startsWith(field.prefix()) ? field.prefix().size() : 0;
    while (place < text.size() && text[place].isSpace())
        ++place;
    if (place < text.size() && text[place] == sign && text != field.specialValueText())
        text[place] = by;
}

template <class Field> QString withHyphen(QString text, const Field& field)
{
    exchangeSign(text, field, minusSign, hyphen);
    return text;
}

} // namespace

QString NumberField::textFromValue(double value) const
{
    return numberText(value, decimals());
}

double NumberField::valueFromText(const QString& text) const
{
    return QDoubleSpinBox::valueFromText(withHyphen(text, *this));
}

QValidator::State NumberField::validate(QString& text, int& position) const
{
    exchangeSign(text, *this, minusSign, hyphen);
    const QValidator::State state = QDoubleSpinBox::validate(text, position);
    exchangeSign(text, *this, hyphen, minusSign);
    return state;
}

QString WholeNumberField::textFromValue(int value) const
{
    QString text = QSpinBox::textFromValue(value);
    if (text.startsWith(hyphen))
        text[0] = minusSign;
    return text;
}

int WholeNumberField::valueFromText(const QString& text) const
{
    return QSpinBox::valueFromText(withHyphen(text, *this));
}

QValidator::State WholeNumberField::validate(QString& text, int& position) const
{
    exchangeSign(text, *this, minusSign, hyphen);
    const QValidator::State state = QSpinBox::validate(text, position);
    exchangeSign(text, *this, hyphen, minusSign);
    return state;
}

} // namespace ui
