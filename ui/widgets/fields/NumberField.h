// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace ui {

/// A field for a number with decimals. It writes numbers as NumberText does, with a true minus sign
/// and no "−0.0", and takes both that sign and "-" where a number is typed or pasted; a "-" becomes
/// the true sign at once. All number fields of the window are of this class or of
/// WholeNumberField.
class NumberField : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    [[nodiscard]] QString textFromValue(double value) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
};

/// The same for whole numbers.
class WholeNumberField : public QSpinBox {
public:
    using QSpinBox::QSpinBox;

protected:
    [[nodiscard]] QString textFromValue(int value) const override;
    [[nodiscard]] int valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
};

} // namespace ui
