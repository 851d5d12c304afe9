// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/scissors/SegmentScissorsTool.h"

#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/splitting/LineAcross.h"
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

/// What lies on the left of a line that is drawn over a view, or on its right.
QPolygonF sideOfLine(const QPolygonF& line, bool left, const QSizeF& view)
{
    glm::dvec2 low(0.0);
    glm::dvec2 high(view.width(), view.height());
    std::vector<glm::dvec2> points;
    for (const QPointF& point : line) {
        points.emplace_back(point.x(), point.y());
        low = glm::min(low, points.back());
        high = glm::max(high, points.back());
    }
    // Pixels are counted downwards.
    if (left)
        std::reverse(points.begin(), points.end());
    QPolygonF side;
    for (const glm::dvec2& point : core::leftOfLine(points, low - 1.0, high + 1.0))
        side << QPointF(point.x, point.y);
    return side;
}

/// An editable range that keeps to what painting is limited to, too.
std::optional<core::EditableRange> withPaintLimits(
    std::optional<core::EditableRange> range, const Workspace::BrushSettings& limits)
{
    if (!limits.onlyBetween)
        return range;
    if (!range)
        range.emplace();
    const double lower = std::min(limits.lower, limits.upper);
    const double upper = std::max(limits.lower, limits.upper);
    range->lower = std::max(range->lower.value_or(lower), lower);
    range->upper = std::min(range->upper.value_or(upper), upper);
    if (*range->lower > *range->upper) { // nothing has such a value
        range->upper = range->lower;
        range->inside.emplace();
    }
    return range;
}

} // namespace

SegmentScissorsTool::SegmentScissorsTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
    , m_trial(workspace)
{
    connect(&workspace, &Workspace::activeSegmentChanged, this, &Tool::overlayChanged);
    connect(&m_trial, &SplitTrial::changed, this, &Tool::overlayChanged);
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
              "would be erased, erases what would be filled, and splits the other side off");
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
        {QStringLiteral("depthByPressure"), m_settings.depthByPressure},
        {QStringLiteral("allShown"), m_settings.allShown}};
}

void SegmentScissorsTool::applySettings(const QJsonObject& json)
{
    using displayJson::read;
    Settings settings = m_settings;
    const int does = json[QLatin1String("does")].toInt(-1);
    if (does >= int(Does::EraseInside) && does <= int(Does::SplitAlong))
        settings.does = Does(does);
    const int shape = json[QLatin1String("shape")].toInt(-1);
    if (shape >= int(Shape::Freehand) && shape <= int(Shape::Ellipse))
        settings.shape = Shape(shape);
    read(json[QLatin1String("depthMm")], settings.depthMm, 0.0, maximumDepthMm);
    read(json[QLatin1String("depthByPressure")], settings.depthByPressure);
    read(json[QLatin1String("allShown")], settings.allShown);
    setSettings(settings);
}

void SegmentScissorsTool::setSettings(const Settings& settings)
{
    if (settings == m_settings)
        return;
    m_sketch.drop();
    m_pressure.end();
    m_trial.drop();
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
    return does == Does::EraseOutside || does == Does::FillOutside || does == Does::SplitOutside;
}

bool SegmentScissorsTool::splits(Does does)
{
    return does >= Does::SplitInside;
}

bool SegmentScissorsTool::hasDepth(Does does)
{
    return !isOutside(does) && does != Does::SplitAlong;
}

double SegmentScissorsTool::depthMm() const
{
    constexpr double leastMm = 0.5; // less would not reach through a voxel
    return m_pressure.of(m_settings.depthMm, leastMm);
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
        return Does::EraseOutside;
    case Does::SplitInside:
        return Does::SplitOutside;
    case Does::SplitOutside:
        return Does::SplitInside;
    case Does::SplitAlong:
        break;
    }
    return Does::SplitAlong; // its larger side
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
    if (labels.empty() && splits(does))
        return tr("no segment to split");
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
        return tr("fills %1 outside").arg(whose);
    case Does::SplitInside:
        return tr("splits off %1 inside").arg(whose);
    case Does::SplitOutside:
        return tr("splits off %1 outside").arg(whose);
    case Does::SplitAlong:
        break;
    }
    return m_inverts ? tr("splits off the larger side of %1").arg(whose)
                     : tr("splits off the smaller side of %1").arg(whose);
}

void SegmentScissorsTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !worksIn(view) || m_sketch.drawing())
        return;
    m_inverts = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    m_sketch.begin(sample.position, view,
        m_settings.does == Does::SplitAlong ? Shape::Line : m_settings.shape);
    m_pressure.begin(
        sample, m_settings.depthByPressure && m_settings.depthMm > 0.0 && hasDepth(doesNow()));
    showCursor(sample.position, view.view);
}

void SegmentScissorsTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_sketch.drawing() || view.view != m_sketch.view().view)
        return;
    m_sketch.extend(sample.position);
    m_pressure.extend(sample);
    lookAtParts();
    showCursor(sample.position, view.view);
}

void SegmentScissorsTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_sketch.drawing())
        return;
    drag(sample, view);
    const ViewContext sketched = m_sketch.view();
    const std::vector<glm::dvec2> curve = m_sketch.finish();
    m_trial.drop();
    if (curve.empty() && m_settings.does == Does::SplitAlong)
        m_workspace.say(tr("Draw a line on the 3D view, across the segment"));
    else if (curve.empty())
        m_workspace.say(tr("Draw a curve on the 3D view; it closes by itself"));
    else if (splits(m_settings.does))
        split(sketched, curve);
    else
        cut(sketched, curve);
    m_pressure.end();
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
        edit.depthMm = depthMm();
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

core::SplitByCurve SegmentScissorsTool::splitOf(const ViewContext& view,
    const std::vector<glm::dvec2>& curve, const core::Document& document) const
{
    using Side = core::SplitByCurve::Side;
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    const int label = m_workspace.activeSegment();
    core::SplitByCurve edit{.segment = label, .view = orthographicView(scene), .curveMm = curve};
    const Does does = doesNow();
    if (does == Does::SplitAlong) {
        edit.open = true;
        edit.side = m_inverts ? Side::Larger : Side::Smaller;
    } else if (does == Does::SplitOutside) {
        edit.side = Side::Outside;
    }
    if (m_settings.depthMm > 0.0 && hasDepth(does))
        edit.depthMm = depthMm();
    edit.into = core::usualParts(document, *document.segment(label), 1).front();
    edit.hidden = core::clipHalfSpaces(scene.clip, m_workspace.volume()->geometry);
    edit.editable = withPaintLimits(
        m_workspace.editableRange(), m_workspace.brushSettings(Workspace::Brush::Paint));
    return edit;
}

void SegmentScissorsTool::split(const ViewContext& view, const std::vector<glm::dvec2>& curve)
{
    const core::Document expected = m_workspace.session()->foreseenDocument();
    if (!expected.segment(m_workspace.activeSegment()))
        return m_workspace.say(tr("There is no segment to split"));
    splitByCurve(m_workspace, splitOf(view, curve, expected));
}

/// Where values or places are limited, the counts would say too much.
void SegmentScissorsTool::lookAtParts()
{
    const core::Document& document = m_workspace.session()->document();
    const core::Segment* segment = document.segment(m_workspace.activeSegment());
    const bool isMeant = splits(m_settings.does) && segment && !segment->locked;
    if (isMeant && limitsText(m_workspace).isEmpty())
        m_trial.look(splitOf(m_sketch.view(), m_sketch.curveMm(), document));
}

QString SegmentScissorsTool::partsLine() const
{
    const core::Document& document = m_workspace.session()->document();
    const core::Segment* segment = document.segment(m_workspace.activeSegment());
    if (!m_sketch.drawing() || !segment)
        return {};
    return m_trial.text(segment->name, core::usualParts(document, *segment, 1).front().name);
}

void SegmentScissorsTool::cancel()
{
    m_sketch.drop();
    m_pressure.end();
    m_trial.drop();
    Q_EMIT overlayChanged();
}

void SegmentScissorsTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_inverts = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    showCursor(sample.position, view.view);
}

QPainterPath SegmentScissorsTool::changedSide(const ViewContext& view) const
{
    QPainterPath changed;
    changed.setFillRule(Qt::WindingFill);
    if (doesNow() == Does::SplitAlong) {
        if (m_trial.parts() && m_trial.parts()->beyond > 0)
            changed.addPolygon(
                sideOfLine(m_sketch.polygon(), m_trial.parts()->isInside, view.sizePixels));
        return changed;
    }
    changed.addPolygon(m_sketch.polygon());
    changed.closeSubpath();
    if (!isOutside(doesNow()))
        return changed;
    QPainterPath all;
    all.addRect(QRectF(QPointF(), view.sizePixels));
    return all.subtracted(changed);
}

/// The curve, and on which side of it something would change, as far as the editable range allows
/// it: hatched where it is erased, in the colour of the new segment where it is split off.
void SegmentScissorsTool::paintCut(QPainter& painter, const ViewContext& view) const
{
    const core::Document& document = m_workspace.session()->document();
    const core::Segment* segment = document.segment(m_workspace.activeSegment());
    const bool isNew = !segment || splits(doesNow());
    QColor tint = isNew ? QColor(nextSegmentColour(document)) : QColor(segment->rgb);
    tint.setAlpha(70);
    QPainterPath changed = changedSide(view);
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
    if (hasDepth(doesNow()))
        lines << (m_settings.depthMm > 0.0 ? tr("%1 mm deep").arg(numberText(depthMm(), 1))
                                           : tr("through everything"));
    lines << target();
    if (const QString limits = limitsText(m_workspace); !limits.isEmpty())
        lines << limits;
    if (const QString parts = partsLine(); !parts.isEmpty())
        lines << parts;
    drawCursorLabel(painter, view.sizePixels, cursor(), 6.0, lines);
}

} // namespace ui
