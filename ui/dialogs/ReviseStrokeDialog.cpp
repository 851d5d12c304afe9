// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/ReviseStrokeDialog.h"

#include "core/document/Document.h"
#include "core/edits/EditSchema.h"
#include "core/edits/ToolMasks.h"

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

QDoubleSpinBox* millimetreBox(
    QWidget* parent, const QString& name, const core::editFields::Number& range, double value)
{
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(name);
    box->setDecimals(1);
    box->setSingleStep(0.5);
    box->setRange(std::max(range.minimum, 0.1), range.maximum);
    box->setSuffix(QStringLiteral(" mm"));
    box->setValue(value);
    return box;
}

/// What a box shows, where it is not what the stroke was drawn with.
std::optional<double> changed(const QDoubleSpinBox& box, double drawn)
{
    // Values that the box rounds are not changed by looking at them.
    const double half = 0.5 * std::pow(10.0, -box.decimals());
    if (std::abs(box.value() - drawn) <= half)
        return {};
    return box.value();
}

} // namespace

ReviseStrokeDialog::ReviseStrokeDialog(const core::StandingStroke& stroke,
    const core::DrillStroke& drawn, const QString& title, const core::Document& document,
    QWidget* parent)
    : QDialog(parent)
    , m_row(stroke.row)
    , m_drawn(drawn)
    , m_radius(millimetreBox(this, QStringLiteral("radius"), core::editSchema::drillRadius,
          stroke.drill()->mask.radiusMm))
    , m_depth(millimetreBox(
          this, QStringLiteral("depth"), core::editSchema::drillDepth, stroke.drill()->depthMm))
    , m_layer(new QComboBox(this))
    , m_throughGaps(new QCheckBox(tr("Goes on behind gaps"), this))
{
    setWindowTitle(tr("Change stroke"));
    m_throughGaps->setObjectName(QStringLiteral("throughGaps"));
    m_throughGaps->setChecked(stroke.drill()->throughGaps);
    m_layer->setObjectName(QStringLiteral("layer"));
    for (const core::SculptLayer& layer : document.layers)
        m_layer->addItem(layer.name, int(layer.id));
    m_layer->setCurrentIndex(m_layer->findData(stroke.drill()->layer));

    auto* heading = new QLabel(title, this);
    heading->setProperty("role", QStringLiteral("heading"));
    auto* note = new QLabel(tr("Only what this stroke touches is worked out again. Later strokes "
                               "stay where they are."),
        this);
    note->setProperty("role", QStringLiteral("secondary"));
    note->setWordWrap(true);
    auto* form = new QFormLayout;
    form->addRow(tr("Radius"), m_radius);
    form->addRow(tr("Depth at full pressure"), m_depth);
    form->addRow(tr("Layer"), m_layer);
    form->addRow(QString(), m_throughGaps);
    form->setRowVisible(m_radius, core::isRound(drawn.mask));
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
    edit.radiusMm = changed(*m_radius, m_drawn.mask.radiusMm);
    edit.depthMm = changed(*m_depth, m_drawn.depthMm);
    if (m_layer->currentIndex() >= 0 && m_layer->currentData().toInt() != m_drawn.layer)
        edit.layer = m_layer->currentData().toInt();
    if (m_throughGaps->isChecked() != m_drawn.throughGaps)
        edit.throughGaps = m_throughGaps->isChecked();
    return edit;
}

} // namespace ui
