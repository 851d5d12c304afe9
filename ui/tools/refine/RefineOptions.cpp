// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/refine/RefineOptions.h"

#include "ui/base/Theme.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/refine/RefineTool.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Refinement.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

namespace ui {

namespace {

QIcon swatch(std::uint32_t rgb)
{
    constexpr int side = 12;
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(QRgb(rgb)));
    painter.drawRoundedRect(pixmap.rect(), 2.0, 2.0);
    return pixmap;
}

} // namespace

RefineOptions::RefineOptions(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_modes(new QButtonGroup(this))
    , m_mark(new QComboBox(this))
    , m_radius(new NumberField(this))
    , m_pressure(pressureButton(this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    const auto add = [&](Refinement::Mode mode, const QString& text, const char* name,
                         const QString& tip) {
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1String(name));
        button->setText(text);
        button->setToolTip(tip);
        button->setCheckable(true);
        button->setFixedHeight(theme::controlHeight);
        m_modes->addButton(button, int(mode));
        layout->addWidget(button);
    };
    using Mode = Refinement::Mode;
    add(Mode::Mark, tr("Mark"), "refineMark",
        tr("Paint what you think of the surface: green stays, yellow follows the mask, red is "
           "free for the tools"));
    add(Mode::Sphere, tr("Sphere"), "refineSphere",
        tr("Push with a ball: outwards from inside, inwards from outside"));
    add(Mode::Scrape, tr("Scrape"), "refineScrape",
        tr("Take down what stands beyond a plane through the pen, across the surface's normal"));
    add(Mode::Drag, tr("Drag"), "refineDrag",
        tr("Draw a point along, and what is around it like a rubber sheet; it is green then"));
    add(Mode::Smooth, tr("Smooth"), "refineSmooth", tr("Even the surface out"));
    add(Mode::Attract, tr("Attract"), "refineAttract",
        tr("Draw the surface to the edge of grey values nearby"));
    add(Mode::Template, tr("Template"), "refineTemplate",
        tr("Draw on any planes how the surface ought to run; what is red takes that shape. Ctrl "
           "or the eraser end rubs contours out"));

    m_mark->setObjectName(QStringLiteral("refineColour"));
    m_mark->setAccessibleName(tr("Mark"));
    m_mark->setFixedHeight(theme::controlHeight);
    const gpu::SurfaceColours colours;
    const auto addMark = [&](core::SurfaceMark mark, const QString& text) {
        m_mark->addItem(swatch(colours.markRgb[std::size_t(mark)]), text, int(mark));
    };
    addMark(core::SurfaceMark::Red, tr("red: wrong"));
    addMark(core::SurfaceMark::Green, tr("green: right"));
    addMark(core::SurfaceMark::Yellow, tr("yellow: not marked"));
    layout->addWidget(m_mark);
    m_radiusLabel = new QLabel(tr("Radius"), this);
    layout->addWidget(m_radiusLabel);
    m_radius->setObjectName(QStringLiteral("refineRadius"));
    m_radius->setFixedHeight(theme::controlHeight);
    m_radius->setKeyboardTracking(false);
    m_radius->setRange(RefineTool::minimumRadiusMm, RefineTool::maximumRadiusMm);
    m_radius->setDecimals(1);
    m_radius->setSingleStep(0.5);
    m_radius->setSuffix(tr(" mm"));
    layout->addWidget(m_radius);
    layout->addWidget(m_pressure);
    m_template = buildTemplate();
    layout->addWidget(m_template);

    showSettings();
    showContours();
    connect(
        &workspace.refinement(), &Refinement::contoursChanged, this, &RefineOptions::showContours);
    connect(&workspace.refinement(), &Refinement::changed, this, &RefineOptions::showContours);
    connect(
        &workspace.refinement(), &Refinement::settingsChanged, this, &RefineOptions::showSettings);
    connect(m_modes, &QButtonGroup::idClicked, this, &RefineOptions::takeSettings);
    connect(m_mark, &QComboBox::activated, this, &RefineOptions::takeSettings);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, &RefineOptions::takeSettings);
    connect(m_pressure, &QToolButton::clicked, this, &RefineOptions::takeSettings);
}

QWidget* RefineOptions::buildTemplate()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    m_contours = new QLabel(row);
    m_contours->setObjectName(QStringLiteral("templateContours"));
    m_contours->setProperty("role", QStringLiteral("secondary"));
    layout->addWidget(m_contours);
    const auto add = [&](const QString& text, const char* name, const QString& tip) {
        auto* button = new QToolButton(row);
        button->setObjectName(QLatin1String(name));
        button->setText(text);
        button->setToolTip(tip);
        button->setFixedHeight(theme::controlHeight);
        layout->addWidget(button);
        return button;
    };
    m_preview = add(tr("Preview"), "templatePreview", tr("What the contours make of the surface"));
    m_preview->setCheckable(true);
    m_take = add(tr("Take"), "templateTake", tr("The surface stays so; the contours go"));
    m_remove = add(tr("Remove last"), "templateRemove", tr("The contour that was drawn last goes"));
    Refinement& refinement = m_workspace.refinement();
    connect(m_preview, &QToolButton::clicked, &refinement, [&refinement](bool on) {
        if (on)
            refinement.previewTemplate();
        else
            refinement.dropPreview();
    });
    connect(m_take, &QToolButton::clicked, &refinement, &Refinement::takeTemplate);
    connect(m_remove, &QToolButton::clicked, &refinement, &Refinement::removeContour);
    return row;
}

void RefineOptions::showContours()
{
    const Refinement& refinement = m_workspace.refinement();
    const auto count = refinement.contours().size();
    m_contours->setText(count == 0 ? tr("draw contours")
            : count == 1           ? tr("1 contour")
                                   : tr("%1 contours").arg(count));
    m_preview->setEnabled(count > 0);
    m_preview->setChecked(refinement.isPreviewing());
    m_take->setEnabled(refinement.canTakeTemplate());
    m_remove->setEnabled(count > 0);
}

void RefineOptions::showSettings()
{
    const Refinement::Settings& settings = m_workspace.refinement().settings();
    const QSignalBlocker radius(m_radius);
    m_modes->button(int(settings.mode))->setChecked(true);
    m_mark->setCurrentIndex(m_mark->findData(int(settings.mark)));
    m_mark->setVisible(settings.mode == Refinement::Mode::Mark);
    m_radius->setValue(settings.radiusMm);
    // A template has no size: the marks say what it reaches.
    const bool isTemplate = settings.mode == Refinement::Mode::Template;
    m_radiusLabel->setVisible(!isTemplate);
    m_radius->setVisible(!isTemplate);
    m_pressure->setChecked(settings.radiusByPressure);
    m_pressure->setVisible(!isTemplate);
    m_template->setVisible(isTemplate);
}

void RefineOptions::takeSettings()
{
    m_workspace.refinement().setSettings({.mode = Refinement::Mode(m_modes->checkedId()),
        .mark = core::SurfaceMark(m_mark->currentData().toInt()),
        .radiusMm = m_radius->value(),
        .radiusByPressure = m_pressure->isChecked()});
}

} // namespace ui
