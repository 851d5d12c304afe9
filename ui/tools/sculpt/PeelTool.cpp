// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/PeelTool.h"

#include "core/edits/kinds/sculpt/PeelCut.h"
#include "ui/base/DisplayJson.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Workspace.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double stepsPerMm = 2.0;

} // namespace

PeelTool::PeelTool(Workspace& workspace, QObject* parent)
    : OutlineTool(workspace, parent)
{
    connect(&workspace, &Workspace::sessionChanged, this, &PeelTool::follow);
    connect(&workspace, &Workspace::documentChanged, this, &PeelTool::follow);
}

QString PeelTool::name() const
{
    return tr("Peel");
}

QString PeelTool::iconName() const
{
    return QStringLiteral("peel");
}

QString PeelTool::hint() const
{
    return m_open ? tr("Peel: the slider or Alt+wheel sets the depth, Enter keeps it, Esc takes "
                       "it back")
                  : tr("Peel: draw a curve on the 3D view; Ctrl or the eraser end restores");
}

QString PeelTool::keys() const
{
    return tr("Alt+wheel depth · Enter keeps · Esc takes back");
}

QWidget* PeelTool::createOptions(QWidget* parent)
{
    auto* options = new QWidget(parent);
    auto* slider = new QSlider(Qt::Horizontal, options);
    slider->setObjectName(QStringLiteral("peelSlider"));
    slider->setRange(int(minimumDepthMm * stepsPerMm), int(maximumDepthMm * stepsPerMm));
    slider->setFixedWidth(220);
    auto* depth = new QDoubleSpinBox(options);
    depth->setObjectName(QStringLiteral("peelDepth"));
    depth->setRange(minimumDepthMm, maximumDepthMm);
    depth->setDecimals(1);
    depth->setSingleStep(0.5);
    depth->setSuffix(tr(" mm"));
    depth->setFixedHeight(theme::controlHeight);
    depth->setKeyboardTracking(false);
    auto* keep = new QPushButton(tr("Keep"), options);
    keep->setObjectName(QStringLiteral("peelKeep"));
    keep->setShortcut(QKeySequence(Qt::Key_Return));
    keep->setToolTip(tr("Keep this peel as a step (Enter)"));
    auto* layout = new QHBoxLayout(options);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new QLabel(tr("Depth"), options));
    layout->addWidget(slider);
    layout->addWidget(depth);
    layout->addWidget(keep);

    const auto show = [this, slider, depth, keep] {
        const QSignalBlocker sliderBlocker(slider);
        const QSignalBlocker depthBlocker(depth);
        slider->setValue(int(std::lround(m_depthMm * stepsPerMm)));
        depth->setValue(m_depthMm);
        keep->setEnabled(m_open);
    };
    show();
    connect(this, &PeelTool::changed, options, show);
    connect(slider, &QSlider::valueChanged, this,
        [this](int steps) { setDepthMm(steps / stepsPerMm); });
    connect(depth, &QDoubleSpinBox::valueChanged, this, &PeelTool::setDepthMm);
    connect(keep, &QPushButton::clicked, this, &PeelTool::confirm);
    return options;
}

QJsonObject PeelTool::settingsJson() const
{
    return {{QStringLiteral("depthMm"), m_depthMm}};
}

void PeelTool::applySettings(const QJsonObject& settings)
{
    double depthMm = m_depthMm;
    displayJson::read(settings[QLatin1String("depthMm")], depthMm);
    setDepthMm(depthMm);
}

void PeelTool::setDepthMm(double depthMm)
{
    depthMm = std::clamp(depthMm, minimumDepthMm, maximumDepthMm);
    if (depthMm == m_depthMm)
        return;
    m_depthMm = depthMm;
    if (m_open)
        workspace().session()->setPeelDepth(depthMm);
    Q_EMIT changed();
    Q_EMIT overlayChanged();
}

void PeelTool::changeDepth(int steps)
{
    const double step = m_depthMm < 10.0 ? 0.5 : 1.0;
    setDepthMm(std::round(m_depthMm / step + steps) * step);
}

void PeelTool::cut(const Sketch& sketch)
{
    core::PeelCut peel;
    peel.layer = workspace().activeLayer();
    peel.view = sketch.view;
    peel.polygonMm = sketch.polygonMm;
    peel.depthMm = m_depthMm;
    peel.surfaceThreshold = surfaceThreshold();
    peel.restore = sketch.restore;
    peel.hidden = sketch.hidden;
    if (const auto begun = workspace().session()->begin(peel); !begun) {
        workspace().fail(begun.error());
        return;
    }
    m_open = true;
    workspace().say(hint());
    Q_EMIT changed();
}

void PeelTool::confirm()
{
    if (!m_open)
        return;
    m_open = false;
    if (core::EditSession* session = workspace().session())
        session->end(core::Ending::Commit);
    workspace().say(tr("Peeled off; Ctrl+L lifts the layer as a piece"));
    Q_EMIT changed();
    Q_EMIT overlayChanged();
}

/// What was chosen stays chosen.
void PeelTool::putAway()
{
    OutlineTool::cancel();
    confirm();
}

void PeelTool::cancel()
{
    OutlineTool::cancel();
    if (!m_open)
        return;
    m_open = false;
    if (core::EditSession* session = workspace().session())
        session->end(core::Ending::Rollback);
    workspace().say(tr("The peel was taken back"));
    Q_EMIT changed();
    Q_EMIT overlayChanged();
}

/// Another step may have closed the peel.
void PeelTool::follow()
{
    const core::EditSession* session = workspace().session();
    if (!m_open || (session && session->transactionOpen()))
        return;
    m_open = false;
    Q_EMIT changed();
}

SurfacePatch PeelTool::taken(SurfacePatch surface) const
{
    surface.keepLargest(core::PeelCut().jumpMm);
    return surface;
}

QStringList PeelTool::lines() const
{
    const QString depth = tr("%1 mm thick").arg(QLocale().toString(m_depthMm, 'f', 1));
    return m_open ? QStringList{depth, tr("Enter keeps it, Esc takes it back")}
                  : QStringList{depth};
}

} // namespace ui
