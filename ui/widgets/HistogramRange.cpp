// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/HistogramRange.h"

#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/widgets/HistogramRangePlot.h"
#include "ui/widgets/fields/NumberField.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ui {

namespace {

constexpr double leastApart = 16.0; ///< logical pixels: two handles and room to catch each

/// What a thousandth of the range needs.
int decimalsFor(const core::Histogram& histogram)
{
    const double range = histogram.maximum - histogram.minimum;
    if (!(range > 0.0))
        return 2;
    return range >= 1.0 ? decimalsForSpan(range) + 1 : decimalsForSpan(range);
}

/// Takes numbers beyond its range for the nearest within it. A plain box would refuse their last
/// digit, and make −102 of −1024 where the volume ends at −1019.
class NumberBox : public NumberField {
public:
    using NumberField::NumberField;

    QValidator::State validate(QString& text, int& position) const override
    {
        const QValidator::State state = NumberField::validate(text, position);
        return state == QValidator::Invalid && number(text) ? QValidator::Intermediate : state;
    }
    void fixup(QString& text) const override
    {
        if (const std::optional<double> typed = number(text))
            text = textFromValue(std::clamp(*typed, minimum(), maximum())) + suffix();
    }

private:
    [[nodiscard]] std::optional<double> number(QString text) const
    {
        if (text.endsWith(suffix()))
            text.chop(suffix().size());
        text.replace(minusSign, QLatin1Char('-'));
        bool isNumber = false;
        const double value = locale().toDouble(text.trimmed(), &isNumber);
        return isNumber ? std::optional(value) : std::nullopt;
    }
};

QDoubleSpinBox* numberBox(QWidget* parent, const QString& name, const QString& accessible)
{
    auto* box = new NumberBox(parent);
    box->setObjectName(name);
    box->setAccessibleName(accessible);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setFixedHeight(theme::controlHeight);
    box->setKeyboardTracking(false);
    box->setStyleSheet(QStringLiteral("padding: 2px 1px"));
    box->setMinimumWidth(75);
    return box;
}

} // namespace

HistogramRange::HistogramRange(QWidget* parent)
    : QWidget(parent)
    , m_plot(new HistogramRangePlot(this))
    , m_lowerBox(numberBox(this, QStringLiteral("rangeLower"), tr("Lower bound")))
    , m_upperBox(numberBox(this, QStringLiteral("rangeUpper"), tr("Upper bound")))
    , m_layout(new QGridLayout(this))
{
    m_plot->setFixedHeight(60);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(4);
    m_layout->addWidget(m_plot, 0, 0, 1, 3);
    m_layout->addWidget(m_lowerBox, 1, 0);
    m_layout->addWidget(m_upperBox, 1, 2);
    m_layout->setColumnStretch(1, 1);

    connect(m_plot, &HistogramRangePlot::rangeDragged, this, &HistogramRange::take);
    connect(m_plot, &HistogramRangePlot::released, this, [this] {
        // Dragged past the edge, a handle could not be caught again.
        if (m_plot->xOf(m_lower) < 0.0 || m_plot->xOf(m_upper) > m_plot->width())
            zoomToRange();
        Q_EMIT rangeSettled();
    });
    connect(m_plot, &HistogramRangePlot::cancelled, this, &HistogramRange::rangeCancelled);
    connect(m_lowerBox, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        take(value, std::max(value, m_upper));
        Q_EMIT rangeSettled();
    });
    connect(m_upperBox, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        take(std::min(value, m_lower), value);
        Q_EMIT rangeSettled();
    });
}

void HistogramRange::setHistogram(const core::Histogram& histogram, const QString& unit)
{
    m_plot->setHistogram(histogram);
    for (QDoubleSpinBox* box : {m_lowerBox, m_upperBox}) {
        const QSignalBlocker blocker(box);
        box->setDecimals(decimalsFor(histogram));
        box->setRange(histogram.minimum, histogram.maximum);
        box->setSuffix(unit.isEmpty() ? QString() : QStringLiteral(" ") + unit);
    }
}

void HistogramRange::setRange(double lower, double upper)
{
    m_lower = std::min(lower, upper);
    m_upper = std::max(lower, upper);
    const QSignalBlocker lowerBlocker(m_lowerBox);
    const QSignalBlocker upperBlocker(m_upperBox);
    m_lowerBox->setValue(m_lower);
    m_upperBox->setValue(m_upper);
    m_plot->setRange(m_lower, m_upper);
}

void HistogramRange::take(double lower, double upper)
{
    if (lower == m_lower && upper == m_upper)
        return;
    setRange(lower, upper);
    Q_EMIT rangeEdited(m_lower, m_upper);
}

void HistogramRange::setMarkers(const std::vector<double>& values)
{
    m_plot->setMarkers(values);
}

void HistogramRange::setBands(const std::vector<std::pair<double, double>>& bands,
    const std::optional<std::pair<double, double>>& stronger)
{
    m_plot->setBands(bands, stronger);
}

void HistogramRange::setMiddleWidget(QWidget* widget)
{
    m_layout->addWidget(widget, 1, 1, Qt::AlignCenter);
}

void HistogramRange::showRange()
{
    const double left = m_plot->xOf(m_lower);
    const double right = m_plot->xOf(m_upper);
    if (left < 0.0 || right > m_plot->width() || right - left < leastApart)
        zoomToRange();
}

void HistogramRange::zoomToRange()
{
    const double margin = std::max(m_upper - m_lower, 1e-9);
    m_plot->showValues(m_lower - margin, m_upper + margin);
}

} // namespace ui
