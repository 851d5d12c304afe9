// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/FloodFillTool.h"

#include "core/edits/engine/SlicePlane.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/session/SegmentWork.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/menus/EditableButton.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/widgets/fields/ValueField.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ui {

namespace {

/// Keeps an edit to the slice that a view shows: of the voxels, or oblique to them. A standard
/// plane of the patient is oblique too if the volume was acquired tilted.
void keepToSlice(
    core::FloodFill& edit, const core::VolumeGeometry& geometry, const ViewContext& view)
{
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const glm::dvec3 normal = glm::normalize(glm::cross(slice.rightLps, slice.downLps));
    const std::optional<core::SlicePlane::OnGrid> onGrid =
        core::slicePlane(geometry, normal, slice.centreLps).onGrid;
    if (onGrid)
        edit.within = core::SliceAxis(onGrid->axis);
    else
        edit.normalLps = normal;
}

/// The widgets of the option bar.
struct FloodOptions {
    QComboBox* reach;
    QDoubleSpinBox* tolerance;
    QCheckBox* corners;
    QCheckBox* overwrite;
};

FloodOptions floodOptions(QWidget* parent)
{
    FloodOptions options{new QComboBox(parent), new NumberField(parent),
        new QCheckBox(FloodFillTool::tr("corners"), parent),
        new QCheckBox(FloodFillTool::tr("over others"), parent)};
    options.reach->setObjectName(QStringLiteral("floodReach"));
    options.reach->setFixedHeight(theme::controlHeight);
    options.reach->addItem(FloodFillTool::tr("in the slice"));
    options.reach->addItem(FloodFillTool::tr("in 3D"));
    options.reach->setToolTip(FloodFillTool::tr("How far it may reach"));
    options.tolerance->setObjectName(QStringLiteral("floodTolerance"));
    options.tolerance->setFixedHeight(theme::controlHeight);
    options.tolerance->setKeyboardTracking(false);
    options.tolerance->setButtonSymbols(QAbstractSpinBox::NoButtons);
    options.tolerance->setRange(0.0, 1e6);
    options.tolerance->setPrefix(QStringLiteral("± "));
    options.tolerance->setFixedWidth(104);
    options.tolerance->setToolTip(
        FloodFillTool::tr("How far values may differ from the one that is clicked (Shift+wheel)"));
    options.corners->setObjectName(QStringLiteral("floodCorners"));
    options.corners->setToolTip(
        FloodFillTool::tr("Voxels also hang together at an edge or a corner"));
    options.overwrite->setObjectName(QStringLiteral("floodOverwrite"));
    options.overwrite->setToolTip(FloodFillTool::tr("Over other segments that are not locked"));
    return options;
}

} // namespace

FloodFillTool::FloodFillTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::activeSegmentChanged, this, &Tool::overlayChanged);
}

QString FloodFillTool::name() const
{
    return tr("Flood fill");
}

QString FloodFillTool::iconName() const
{
    return QStringLiteral("flood-fill");
}

QString FloodFillTool::hint() const
{
    return tr("Flood fill: click a region on a slice; Ctrl or the eraser end takes a region away");
}

QString FloodFillTool::keys() const
{
    return tr("Shift+wheel tolerance · Ctrl erases · Esc abandons");
}

QWidget* FloodFillTool::createOptions(QWidget* parent)
{
    auto* options = new QWidget(parent);
    auto* layout = new QHBoxLayout(options);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new SeedOptions(m_workspace, {}, options));
    const FloodOptions its = floodOptions(options);
    layout->addWidget(its.reach);
    layout->addWidget(its.tolerance);
    layout->addWidget(its.corners);
    layout->addWidget(its.overwrite);
    layout->addWidget(new EditableButton(m_workspace, options));
    const auto show = [this, its] {
        const QSignalBlocker reach(its.reach);
        const QSignalBlocker tolerance(its.tolerance);
        const QSignalBlocker corners(its.corners);
        const QSignalBlocker overwrite(its.overwrite);
        const core::Volume* volume = m_workspace.volume();
        its.reach->setCurrentIndex(m_settings.in3D ? 1 : 0);
        its.tolerance->setDecimals(
            volume ? valueFieldDecimals(volume->maximum - volume->minimum) : 0);
        its.tolerance->setSuffix(volume ? QLatin1Char(' ') + volume->unit : QString());
        its.tolerance->setValue(m_settings.tolerance);
        its.corners->setChecked(m_settings.corners);
        its.overwrite->setChecked(
            m_workspace.brushSettings(Workspace::Brush::Paint).overwriteUnlocked);
    };
    const auto take = [this, its] {
        setSettings({.in3D = its.reach->currentIndex() == 1,
            .corners = its.corners->isChecked(),
            .tolerance = its.tolerance->value()});
        // It is the same choice as for painting and outlines.
        Workspace::BrushSettings paint = m_workspace.brushSettings(Workspace::Brush::Paint);
        paint.overwriteUnlocked = its.overwrite->isChecked();
        m_workspace.setBrushSettings(Workspace::Brush::Paint, paint);
    };
    show();
    connect(this, &FloodFillTool::settingsChanged, options, show);
    connect(&m_workspace, &Workspace::brushSettingsChanged, options, show);
    connect(&m_workspace, &Workspace::sessionChanged, options, show);
    connect(its.reach, &QComboBox::activated, options, take);
    connect(its.tolerance, &QDoubleSpinBox::valueChanged, options, take);
    connect(its.corners, &QCheckBox::clicked, options, take);
    connect(its.overwrite, &QCheckBox::clicked, options, take);
    return options;
}

QJsonObject FloodFillTool::settingsJson() const
{
    return {{QStringLiteral("in3D"), m_settings.in3D},
        {QStringLiteral("corners"), m_settings.corners},
        {QStringLiteral("tolerance"), m_settings.tolerance}};
}

void FloodFillTool::applySettings(const QJsonObject& settings)
{
    Settings now = m_settings;
    now.in3D = settings[QLatin1String("in3D")].toBool(now.in3D);
    now.corners = settings[QLatin1String("corners")].toBool(now.corners);
    const double tolerance = settings[QLatin1String("tolerance")].toDouble(now.tolerance);
    if (tolerance >= 0.0 && tolerance <= 1e6)
        now.tolerance = tolerance;
    setSettings(now);
}

void FloodFillTool::setSettings(const Settings& settings)
{
    if (settings == m_settings)
        return;
    m_settings = settings;
    Q_EMIT settingsChanged();
    Q_EMIT overlayChanged();
}

/// A fiftieth of the values' range is about what one sees, in whole units where there are any.
double FloodFillTool::step() const
{
    const core::Volume* volume = m_workspace.volume();
    const double span = volume ? volume->maximum - volume->minimum : 0.0;
    return span < 50.0 ? span / 200.0 : std::max(1.0, std::round(m_settings.tolerance / 10.0));
}

void FloodFillTool::changeRadius(int steps)
{
    Settings now = m_settings;
    now.tolerance = std::clamp(now.tolerance + steps * step(), 0.0, 1e6);
    setSettings(now);
}

bool FloodFillTool::worksIn(const ViewContext& view) const
{
    return view.isSlice();
}

void FloodFillTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !worksIn(view))
        return;
    hover(sample, view);
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    core::FloodFill edit{.segment = 0,
        .placeLps = view.toLps(sample.position),
        .within = {},
        .corners = m_settings.corners,
        .erase = m_erases};
    if (!m_settings.in3D)
        keepToSlice(edit, geometry, view);
    if (!core::firstVoxel(edit, geometry))
        return m_workspace.say(tr("Click inside the volume"));
    if (m_erases && m_workspace.session()->document().segments.empty())
        return m_workspace.say(tr("There is no segment to erase"));
    // An impatient second click would do it all once more.
    core::EditSession& session = *m_workspace.session();
    if (!session.segmentWork().isPreview() && session.segmentWork().percent())
        return m_workspace.say(tr("A segment is being worked out; Esc abandons it"));
    const core::Result<int> label = ensureActiveSegment(m_workspace);
    if (!label)
        return m_workspace.fail(label.error());
    edit.segment = *label;
    if (!m_erases) {
        edit.tolerance = m_settings.tolerance;
        edit.overwriteUnlocked =
            m_workspace.brushSettings(Workspace::Brush::Paint).overwriteUnlocked;
    }
    floodFill(m_workspace, edit);
}

void FloodFillTool::cancel()
{
    core::EditSession* session = m_workspace.session();
    if (session && !session->segmentWork().isPreview()) // which is a dialog's
        session->segmentWork().abort();
}

void FloodFillTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_erases = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    showCursor(sample.position, view.view);
}

QString FloodFillTool::action(bool erases) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return {};
    const core::Segment* segment = session->document().segment(m_workspace.activeSegment());
    if (!segment)
        return erases ? tr("no segment to erase") : tr("fills a new segment");
    if (segment->locked)
        return tr("%1 is locked").arg(segment->name);
    return (erases ? tr("takes a region of %1 away") : tr("fills %1")).arg(segment->name);
}

void FloodFillTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !worksIn(view) || !isUnderPointer(view))
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(cursor(), 2.0, 2.0);
    QStringList lines{action(m_erases)};
    const QString reach = m_settings.in3D ? tr("in 3D") : tr("in the slice");
    if (m_erases) {
        lines += reach;
    } else {
        const core::Volume& volume = *m_workspace.volume();
        lines +=
            tr("± %1, %2")
                .arg(valueText(m_settings.tolerance, volume.unit, volume.maximum - volume.minimum),
                    reach);
    }
    if (const QString editable = m_workspace.editableText(); !editable.isEmpty())
        lines += editable;
    drawCursorLabel(painter, view.sizePixels, cursor(), 6.0, lines);
}

} // namespace ui
