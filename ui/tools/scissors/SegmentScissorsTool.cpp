// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/scissors/SegmentScissorsTool.h"

#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/session/EditSession.h"
#include "ui/base/DisplayJson.h"
#include "ui/base/NumberText.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/PickQuestion.h"
#include "ui/tools/common/PaintLimits.h"
#include "ui/tools/scissors/EditablePart.h"
#include "ui/tools/scissors/SegmentScissorsOptions.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace ui {

namespace {

using Does = SegmentScissorsTool::Does;

} // namespace

SegmentScissorsTool::SegmentScissorsTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::activeSegmentChanged, this, &Tool::overlayChanged);
    // A curve ends with the session it was begun in.
    connect(
        &workspace, &Workspace::sessionClosing, this, [this] { SegmentScissorsTool::cancel(); });
    connect(
        &workspace, &Workspace::sessionChanged, this, [this] { SegmentScissorsTool::cancel(); });
}

QString SegmentScissorsTool::name() const
{
    return tr("Scissors");
}

QString SegmentScissorsTool::longName() const
{
    return tr("Segment scissors");
}

QString SegmentScissorsTool::iconName() const
{
    return QStringLiteral("segment-scissors");
}

QString SegmentScissorsTool::hint() const
{
    return tr("Segment scissors: draw a curve on the 3D view; Ctrl or the eraser end fills what "
              "would be erased, and erases what would be filled");
}

QString SegmentScissorsTool::keys() const
{
    return tr("Ctrl+Shift+wheel depth · Ctrl inverts · Esc cancels");
}

QWidget* SegmentScissorsTool::createOptions(QWidget* parent)
{
    return new SegmentScissorsOptions(m_workspace, *this, parent);
}

QJsonObject SegmentScissorsTool::settingsJson() const
{
    return {{QStringLiteral("does"), int(m_settings.does)},
        {QStringLiteral("shape"), int(m_settings.shape)},
        {QStringLiteral("depthMm"), m_settings.depthMm},
        {QStringLiteral("allShown"), m_settings.allShown}};
}

void SegmentScissorsTool::applySettings(const QJsonObject& json)
{
    using displayJson::read;
    Settings settings = m_settings;
    const int does = json[QLatin1String("does")].toInt(-1);
    if (does >= int(Does::EraseInside) && does <= int(Does::FillOutside))
        settings.does = Does(does);
    const int shape = json[QLatin1String("shape")].toInt(-1);
    if (shape >= int(Shape::Freehand) && shape <= int(Shape::Ellipse))
        settings.shape = Shape(shape);
    read(json[QLatin1String("depthMm")], settings.depthMm, 0.0, maximumDepthMm);
    read(json[QLatin1String("allShown")], settings.allShown);
    setSettings(settings);
}

void SegmentScissorsTool::setSettings(const Settings& settings)
{
    if (settings == m_settings)
        return;
    m_sketch.drop();
    m_settings = settings;
    Q_EMIT settingsChanged();
    Q_EMIT overlayChanged();
}

void SegmentScissorsTool::changeDepth(int steps)
{
    Settings settings = m_settings;
    settings.depthMm = std::clamp(settings.depthMm + steps, 0.0, maximumDepthMm);
    setSettings(settings);
}

bool SegmentScissorsTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return scene && scene->orthographic;
}

bool SegmentScissorsTool::erases(Does does)
{
    return does == Does::EraseInside || does == Does::EraseOutside;
}

bool SegmentScissorsTool::isOutside(Does does)
{
    return does == Does::EraseOutside || does == Does::FillOutside;
}

Does SegmentScissorsTool::doesNow() const
{
    if (!m_inverts)
        return m_settings.does;
    switch (m_settings.does) {
    case Does::EraseInside:
        return Does::FillInside;
    case Does::EraseOutside:
        return Does::FillOutside;
    case Does::FillInside:
        return Does::EraseInside;
    case Does::FillOutside:
        break;
    }
    return Does::EraseOutside;
}

std::vector<int> SegmentScissorsTool::targets() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return {};
    const core::Document& document = session->document();
    const int active = m_workspace.activeSegment();
    const core::Segment* chosen = document.segment(active);
    if (!m_settings.allShown || !erases(doesNow()))
        return chosen ? std::vector<int>{active} : std::vector<int>();
    std::vector<int> labels;
    std::optional<std::uint8_t> plane; // that of the chosen one, or else of the first
    if (chosen)
        plane = chosen->plane;
    for (const core::Segment& segment : document.segments) {
        const bool isShown = m_workspace.viewOptions().showSegments
            && m_workspace.segmentDisplay().visible[segment.label];
        if (!isShown || segment.locked || segment.plane != plane.value_or(segment.plane))
            continue;
        plane = segment.plane;
        labels.push_back(segment.label);
    }
    const auto first = std::find(labels.begin(), labels.end(), active);
    if (first != labels.end())
        std::rotate(labels.begin(), first, first + 1);
    return labels;
}

QString SegmentScissorsTool::target() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return {};
    const Does does = doesNow();
    const std::vector<int> labels = targets();
    if (labels.empty())
        return erases(does) ? tr("no segment to erase") : tr("fills a new segment");
    const core::Segment* segment = session->document().segment(labels.front());
    if (segment->locked)
        return tr("%1 is locked").arg(segment->name);
    const QString whose =
        labels.size() > 1 ? tr("%n segments", nullptr, int(labels.size())) : segment->name;
    switch (does) {
    case Does::EraseInside:
        return tr("erases %1 inside").arg(whose);
    case Does::EraseOutside:
        return tr("erases %1 outside").arg(whose);
    case Does::FillInside:
        return tr("fills %1 inside").arg(whose);
    case Does::FillOutside:
        break;
    }
    return tr("fills %1 outside").arg(whose);
}

void SegmentScissorsTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !worksIn(view) || m_sketch.drawing())
        return;
    m_inverts = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    m_sketch.begin(sample.position, view, m_settings.shape);
    showCursor(sample.position, view.view);
}

void SegmentScissorsTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_sketch.drawing() || view.view != m_sketch.view().view)
        return;
    m_sketch.extend(sample.position);
    showCursor(sample.position, view.view);
}

void SegmentScissorsTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_sketch.drawing())
        return;
    drag(sample, view);
    const ViewContext sketched = m_sketch.view();
    const std::vector<glm::dvec2> curve = m_sketch.finish();
    if (curve.empty())
        m_workspace.say(tr("Draw a curve on the 3D view; it closes by itself"));
    else
        cut(sketched, curve);
    showCursor(sample.position, view.view);
}

void SegmentScissorsTool::cut(const ViewContext& view, const std::vector<glm::dvec2>& curve)
{
    const Does does = doesNow();
    std::vector<int> labels = targets();
    if (labels.empty() && erases(does))
        return m_workspace.say(tr("There is no segment to erase"));
    if (labels.empty()) {
        const core::Result<int> label = ensureActiveSegment(m_workspace);
        if (!label)
            return m_workspace.fail(label.error());
        labels = {*label};
    }
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    const Workspace::BrushSettings& limits = m_workspace.brushSettings(Workspace::Brush::Paint);
    core::SegmentScissors edit{
        .segment = labels.front(), .view = orthographicView(scene), .polygonMm = curve};
    edit.erase = erases(does);
    edit.outside = isOutside(does);
    if (m_settings.depthMm > 0.0 && !edit.outside)
        edit.depthMm = m_settings.depthMm;
    if (labels.size() > 1) {
        edit.others = std::vector<int>(labels.begin() + 1, labels.end());
        std::sort(edit.others->begin(), edit.others->end());
    }
    if (limits.onlyBetween) {
        edit.lower = std::min(limits.lower, limits.upper);
        edit.upper = std::max(limits.lower, limits.upper);
    }
    edit.overwriteUnlocked = limits.overwriteUnlocked && !edit.erase;
    edit.hidden = core::clipHalfSpaces(scene.clip, m_workspace.volume()->geometry);
    edit.editable = m_workspace.editableRange();
    if (const auto applied = m_workspace.session()->apply(edit); !applied)
        m_workspace.fail(applied.error());
}

void SegmentScissorsTool::cancel()
{
    m_sketch.drop();
    Q_EMIT overlayChanged();
}

void SegmentScissorsTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_inverts = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    showCursor(sample.position, view.view);
}

/// The curve, and on which side of it something would change, as far as the editable range allows
/// it: hatched where it is erased.
void SegmentScissorsTool::paintCut(QPainter& painter, const ViewContext& view) const
{
    const core::Document& document = m_workspace.session()->document();
    const core::Segment* segment = document.segment(m_workspace.activeSegment());
    QColor tint = segment ? QColor(segment->rgb) : QColor(nextSegmentColour(document));
    tint.setAlpha(70);
    QPainterPath inside;
    inside.setFillRule(Qt::WindingFill);
    inside.addPolygon(m_sketch.polygon());
    inside.closeSubpath();
    QPainterPath changed = inside;
    if (isOutside(doesNow())) {
        changed = QPainterPath();
        changed.addRect(QRectF(QPointF(), view.sizePixels));
        changed = changed.subtracted(inside);
    }
    if (const auto range = m_workspace.editableRange())
        changed = editablePart(*range, changed, m_workspace.volume()->geometry, view);
    painter.fillPath(changed, erases(doesNow()) ? QBrush(tint, Qt::BDiagPattern) : QBrush(tint));
    m_sketch.paint(painter);
}

void SegmentScissorsTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !isUnderPointer(view) || !worksIn(view))
        return;
    if (m_sketch.drawing())
        paintCut(painter, view);
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(cursor(), 2.0, 2.0);
    QStringList lines;
    if (!isOutside(doesNow()))
        lines << (m_settings.depthMm > 0.0 ? tr("%1 mm deep").arg(numberText(m_settings.depthMm, 1))
                                           : tr("through everything"));
    lines << target();
    if (const QString limits = limitsText(m_workspace); !limits.isEmpty())
        lines << limits;
    drawCursorLabel(painter, view.sizePixels, cursor(), 6.0, lines);
}

} // namespace ui
