// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/session/ReviseStrokeDialog.h"

#include "core/document/Document.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/schema/HistorySchema.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/history/StandingStrokes.h"
#include "ui/widgets/fields/NumberField.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double percent = 100.0;

double lengthOf(const std::vector<glm::dvec2>& outline)
{
    double length = 0.0;
    for (std::size_t i = 1; i < outline.size(); ++i)
        length += glm::length(outline[i] - outline[i - 1]);
    return length;
}

/// How many times as large as it was drawn an outline counts now.
double factorOf(const core::SculptEdit& now, const core::SculptEdit& drawn)
{
    const auto* const outline = core::outlineOf(now);
    const auto* const before = core::outlineOf(drawn);
    if (!outline || !before || lengthOf(*before) <= 0.0)
        return 1.0;
    // Factors are kept in 1024ths.
    return std::round(lengthOf(*outline) / lengthOf(*before) * 1024.0) / 1024.0;
}

} // namespace

struct ReviseStrokeDialog::Kind {
    const char* name;
    QString label;
    std::optional<double> core::StrokeParameters::*parameter;
    std::optional<double> core::ReviseStroke::*edit;
    core::editFields::Number range;
};

void ReviseStrokeDialog::addField(
    QFormLayout& form, const Kind& kind, const core::StrokeParameters& now)
{
    const std::optional<double> drawn = m_drawn.*kind.parameter;
    if (!drawn)
        return;
    const bool share = kind.edit == &core::ReviseStroke::factor;
    auto* box = new NumberField(this);
    box->setObjectName(QLatin1String(kind.name));
    box->setDecimals(share ? 0 : 1);
    box->setSingleStep(share ? 10.0 : 0.5);
    const double perUnit = share ? percent : 1.0;
    box->setRange(kind.range.minimum > 0.0 ? std::max(kind.range.minimum * perUnit, 0.1) : 0.0,
        kind.range.maximum * perUnit);
    box->setSuffix(share ? tr(" %") : tr(" mm"));
    const double counts = (now.*kind.parameter).value_or(*drawn);
    box->setValue(counts * perUnit);
    if (share)
        box->setToolTip(tr("In per cent of how it was drawn"));
    form.addRow(kind.label, box);
    m_fields.push_back({box, kind.edit, *drawn, counts, perUnit});
}

ReviseStrokeDialog::ReviseStrokeDialog(const core::StandingStroke& stroke,
    const core::SculptEdit& drawn, const QString& title, const core::Document& document,
    QWidget* parent)
    : QDialog(parent)
    , m_row(stroke.row)
    , m_drawn(core::parametersOf(drawn))
    , m_layer(new QComboBox(this))
    , m_throughGaps(new QCheckBox(tr("Goes on behind gaps"), this))
{
    using core::editSchema::drillDepth;
    using core::editSchema::maskSide;
    using core::editSchema::peelDepth;
    using Now = core::StrokeParameters;
    using Edit = core::ReviseStroke;
    Now now = core::parametersOf(stroke.form);
    if (now.factor)
        now.factor = factorOf(stroke.form, drawn);
    const bool pressed = core::isPressed(drawn);
    setWindowTitle(tr("Change stroke"));
    m_throughGaps->setObjectName(QStringLiteral("throughGaps"));
    m_throughGaps->setChecked(now.throughGaps.value_or(false));
    m_layer->setObjectName(QStringLiteral("layer"));
    for (const core::SculptLayer& layer : document.layers)
        m_layer->addItem(layer.name, int(layer.id));
    m_layer->setCurrentIndex(m_layer->findData(now.layer));

    auto* heading = new QLabel(title, this);
    heading->setProperty("role", QStringLiteral("heading"));
    heading->setWordWrap(true);
    auto* note = new QLabel(tr("Only what this stroke touches is worked out again. Later strokes "
                               "stay where they are."),
        this);
    note->setProperty("role", QStringLiteral("secondary"));
    note->setWordWrap(true);
    auto* form = new QFormLayout;
    const bool peeled = drawn.is<core::PeelCut>();
    for (const Kind& kind : {Kind{"radius", tr("Radius"), &Now::radiusMm, &Edit::radiusMm,
                                 core::editSchema::drillRadius},
             Kind{"side", tr("Side"), &Now::sideMm, &Edit::sideMm, maskSide},
             Kind{"width", tr("Width"), &Now::widthMm, &Edit::widthMm, maskSide},
             Kind{"height", tr("Height"), &Now::heightMm, &Edit::heightMm, maskSide},
             Kind{"factor", tr("Size of the outline"), &Now::factor, &Edit::factor,
                 core::editSchema::outlineFactor},
             Kind{"depth", pressed ? tr("Depth at full pressure") : tr("Depth"), &Now::depthMm,
                 &Edit::depthMm, peeled ? peelDepth : drillDepth},
             Kind{"softness", tr("Soft edge"), &Now::softnessMm, &Edit::softnessMm,
                 core::editSchema::maskSoftness}})
        addField(*form, kind, now);
    if (auto* softness = findChild<QDoubleSpinBox*>(QStringLiteral("softness")))
        softness->setSpecialValueText(tr("sharp"));
    form->addRow(tr("Layer"), m_layer);
    form->addRow(QString(), m_throughGaps);
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

    // From above to below, whatever was made first.
    std::vector<QWidget*> order;
    for (const Field& field : m_fields)
        order.push_back(field.box);
    order.insert(order.end(), {m_layer, m_throughGaps});
    for (std::size_t i = 1; i < order.size(); ++i)
        setTabOrder(order[i - 1], order[i]);
    order.front()->setFocus();
}

core::ReviseStroke ReviseStrokeDialog::edit() const
{
    core::ReviseStroke edit{.row = m_row};
    for (const Field& field : m_fields) {
        // Values that the box rounds are not changed by looking at them.
        const double half = 0.5 * std::pow(10.0, -field.box->decimals());
        const bool kept = std::abs(field.box->value() - field.now * field.perUnit) <= half;
        const double chosen = kept ? field.now : field.box->value() / field.perUnit;
        if (chosen != field.drawn)
            edit.*field.edit = chosen;
    }
    if (m_layer->currentIndex() >= 0 && m_layer->currentData().toInt() != m_drawn.layer)
        edit.layer = m_layer->currentData().toInt();
    if (m_drawn.throughGaps && m_throughGaps->isChecked() != *m_drawn.throughGaps)
        edit.throughGaps = m_throughGaps->isChecked();
    return edit;
}

} // namespace ui
