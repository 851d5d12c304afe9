// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/ReviseStrokeDialog.h"

#include "core/document/Document.h"
#include "core/edits/EditSchema.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace ui {

namespace {

QDoubleSpinBox* millimetreBox(QWidget* parent, const char* name,
    const core::editFields::Number& range, const std::optional<double>& value)
{
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setDecimals(1);
    box->setSingleStep(0.5);
    box->setRange(range.minimum > 0.0 ? std::max(range.minimum, 0.1) : 0.0, range.maximum);
    box->setSuffix(QStringLiteral(" mm"));
    box->setValue(value.value_or(0.0));
    return box;
}

/// What a box shows, where it is not what the stroke was drawn with.
std::optional<double> changed(const QDoubleSpinBox& box, const std::optional<double>& drawn)
{
    if (!drawn)
        return {};
    // Values that the box rounds are not changed by looking at them.
    const double half = 0.5 * std::pow(10.0, -box.decimals());
    if (std::abs(box.value() - *drawn) <= half)
        return {};
    return box.value();
}

} // namespace

ReviseStrokeDialog::ReviseStrokeDialog(const core::StandingStroke& stroke,
    const core::SculptEdit& drawn, const QString& title, const core::Document& document,
    QWidget* parent)
    : QDialog(parent)
    , m_row(stroke.row)
    , m_drawn(core::parametersOf(drawn))
    , m_layer(new QComboBox(this))
    , m_throughGaps(new QCheckBox(tr("Goes on behind gaps"), this))
{
    const core::StrokeParameters now = core::parametersOf(stroke.form);
    const bool pressed = std::holds_alternative<core::DrillStroke>(drawn);
    m_radius = millimetreBox(this, "radius", core::editSchema::drillRadius, now.radiusMm);
    m_depth = millimetreBox(this, "depth",
        std::holds_alternative<core::PeelCut>(drawn) ? core::editSchema::peelDepth
                                                     : core::editSchema::drillDepth,
        now.depthMm);
    m_softness = millimetreBox(this, "softness", core::editSchema::maskSoftness, now.softnessMm);
    m_softness->setSpecialValueText(tr("sharp"));
    setWindowTitle(tr("Change stroke"));
    m_throughGaps->setObjectName(QStringLiteral("throughGaps"));
    m_throughGaps->setChecked(now.throughGaps.value_or(false));
    m_layer->setObjectName(QStringLiteral("layer"));
    for (const core::SculptLayer& layer : document.layers)
        m_layer->addItem(layer.name, int(layer.id));
    m_layer->setCurrentIndex(m_layer->findData(now.layer));

    auto* heading = new QLabel(title, this);
    heading->setProperty("role", QStringLiteral("heading"));
    auto* note = new QLabel(tr("Only what this stroke touches is worked out again. Later strokes "
                               "stay where they are."),
        this);
    note->setProperty("role", QStringLiteral("secondary"));
    note->setWordWrap(true);
    auto* form = new QFormLayout;
    form->addRow(tr("Radius"), m_radius);
    form->addRow(pressed ? tr("Depth at full pressure") : tr("Depth"), m_depth);
    form->addRow(tr("Soft edge"), m_softness);
    form->addRow(tr("Layer"), m_layer);
    form->addRow(QString(), m_throughGaps);
    form->setRowVisible(m_radius, m_drawn.radiusMm.has_value());
    form->setRowVisible(m_depth, m_drawn.depthMm.has_value());
    form->setRowVisible(m_softness, m_drawn.softnessMm.has_value());
    form->setRowVisible(m_throughGaps, m_drawn.throughGaps.has_value());
    // With one layer there is nothing to choose.
    form->setRowVisible(m_layer, m_layer->count() > 1);
    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(tr("Change"), QDialogButtonBox::AcceptRole);
    buttons->addButton(QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(heading);
    layout->addLayout(form);
    layout->addWidget(note);
    layout->addWidget(buttons);
    setMinimumWidth(340);
}

core::ReviseStroke ReviseStrokeDialog::edit() const
{
    core::ReviseStroke edit{.row = m_row};
    edit.radiusMm = changed(*m_radius, m_drawn.radiusMm);
    edit.depthMm = changed(*m_depth, m_drawn.depthMm);
    edit.softnessMm = changed(*m_softness, m_drawn.softnessMm);
    if (m_layer->currentIndex() >= 0 && m_layer->currentData().toInt() != m_drawn.layer)
        edit.layer = m_layer->currentData().toInt();
    if (m_drawn.throughGaps && m_throughGaps->isChecked() != *m_drawn.throughGaps)
        edit.throughGaps = m_throughGaps->isChecked();
    return edit;
}

} // namespace ui
