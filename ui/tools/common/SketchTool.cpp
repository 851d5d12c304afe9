// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/SketchTool.h"

#include "ui/base/NumberText.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/LookingDirection.h"
#include "ui/tools/aim/SeenVoxels.h"
#include "ui/tools/aim/WaitingStroke.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>
#include <QPointer>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

glm::dvec2 pixelOf(const PointerSample& sample)
{
    return {sample.position.x(), sample.position.y()};
}

constexpr double leastReachMm = 0.5;
constexpr double greatestReachMm = 10.0;

} // namespace

SketchTool::SketchTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_strokeView.reset();
        m_path.clear();
        m_waiting.clear();
        sketchOver();
        Q_EMIT overlayChanged();
        Q_EMIT stepsChanged();
    });
}

QString SketchTool::keys() const
{
    return tr("Esc drops the sketch");
}

QToolButton* SketchTool::widthButton(QWidget* parent)
{
    QToolButton* button = pressureButton(parent);
    button->setAccessibleName(tr("Pressure: width"));
    button->setToolTip(
        tr("Pressure: width, that is, a pen sketches as wide as it is pressed; how wide at most, "
           "[ ] and Shift+wheel say. Off: pressure does nothing, as with a mouse."));
    const auto show = [this, button] { button->setChecked(m_byPressure); };
    show();
    connect(this, &SketchTool::settingsChanged, button, show);
    connect(button, &QToolButton::clicked, this, [this](bool checked) {
        m_byPressure = checked;
        Q_EMIT overlayChanged();
    });
    return button;
}

QJsonObject SketchTool::settingsJson() const
{
    return {{QStringLiteral("byPressure"), m_byPressure}, {QStringLiteral("reachMm"), m_reachMm}};
}

void SketchTool::applySettings(const QJsonObject& settings)
{
    m_byPressure = settings[QLatin1String("byPressure")].toBool(m_byPressure);
    m_reachMm = std::clamp(
        settings[QLatin1String("reachMm")].toDouble(m_reachMm), leastReachMm, greatestReachMm);
    Q_EMIT settingsChanged();
}

void SketchTool::changeRadius(int steps)
{
    m_reachMm = std::clamp(m_reachMm + 0.5 * steps, leastReachMm, greatestReachMm);
    Q_EMIT overlayChanged();
}

QStringList SketchTool::widthLines() const
{
    if (!m_byPressure)
        return {};
    return {tr("pressed fully %1 mm to each side").arg(numberText(m_reachMm, 1))};
}

bool SketchTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return !scene || (scene->orthographic && scene->context != gpu::Context::CutAway);
}

void SketchTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.volume() || !worksIn(view) || m_strokeView)
        return;
    m_drawn = {.modifiers = sample.modifiers, .withEraser = sample.eraserEnd};
    m_strokeView = view;
    m_path.clear();
    m_pressedPixels = sample.isPen && m_byPressure ? m_reachMm / view.mmPerPixel() : 0.0;
    addPoint(sample);
    sketchBegan(view);
    sketchGrew(m_path);
    hover(sample, view);
}

void SketchTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_strokeView || view.view != m_strokeView->view)
        return;
    addPoint(sample);
    sketchGrew(m_path);
    hover(sample, view);
}

void SketchTool::addPoint(const PointerSample& sample)
{
    m_path.points.push_back(pixelOf(sample));
    if (m_pressedPixels > 0.0)
        m_path.radii.push_back(m_pressedPixels * pressedShare(sample));
}

double SketchTool::widestPixels() const
{
    return m_path.radii.empty() ? 0.0 : *std::max_element(m_path.radii.begin(), m_path.radii.end());
}

void SketchTool::release(const PointerSample&, const ViewContext&)
{
    if (!m_strokeView)
        return;
    const int active = m_workspace.activeSegment();
    if (m_workspace.session()->foreseenDocument().segment(active))
        m_drawn.segment = active;
    m_drawn.growthPlane = m_workspace.growthPlane();
    // On the 3D view the sketch is not over before it is known what was seen.
    const bool waits = !finishOtherwise(m_path.points, *m_strokeView) && !commitOnSlice();
    if (waits)
        askForSketch();
    m_strokeView.reset();
    m_path.clear();
    m_drawn = {};
    if (!waits)
        sketchOver();
    Q_EMIT overlayChanged();
}

void SketchTool::cancel()
{
    if (!m_strokeView)
        return;
    m_strokeView.reset();
    m_path.clear();
    sketchOver();
    m_workspace.say(tr("The sketch was dropped"));
    Q_EMIT overlayChanged();
}

void SketchTool::takeStepBack()
{
    if (drawing())
        return cancel(); // it was drawn after those that wait
    if (m_waiting.empty())
        return;
    m_waiting.pop_back();
    sketchOver();
    m_workspace.say(tr("The sketch was dropped"));
    Q_EMIT overlayChanged();
    Q_EMIT stepsChanged();
}

QString SketchTool::stepText() const
{
    return waitingStrokeText();
}

bool SketchTool::commitOnSlice()
{
    if (!m_strokeView->isSlice())
        return false;
    const core::Volume& volume = *m_workspace.volume();
    const std::vector<glm::ivec3> voxels = voxelsUnder(m_path, *m_strokeView, volume);
    if (voxels.empty())
        m_workspace.say(outsideText());
    else
        commit(voxels);
    return true;
}

void SketchTool::askWhatIsSeen(const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm,
    const std::function<void(const core::Result<SeenVoxels>&)>& then)
{
    const auto asked = std::make_shared<const Drawn>(m_drawn);
    m_waiting.push_back(asked);
    Q_EMIT stepsChanged();
    ui::askWhatIsSeen(m_workspace, scene, planeMm,
        [tool = QPointer<SketchTool>(this), waiting = std::weak_ptr<const Drawn>(asked), then](
            const core::Result<SeenVoxels>& seen) {
            const std::shared_ptr<const Drawn> drawn = waiting.lock();
            if (!tool || !drawn)
                return;
            std::erase(tool->m_waiting, drawn);
            // The next sketch may have begun, with other keys.
            const Drawn next = std::exchange(tool->m_drawn, *drawn);
            then(seen);
            tool->m_drawn = next;
            if (!tool->drawing())
                tool->sketchOver();
            Q_EMIT tool->stepsChanged();
        });
}

void SketchTool::askForSketch()
{
    const auto& scene = std::get<gpu::VolumeScene>(m_strokeView->scene);
    askWhatIsSeen(scene, planePointsUnder(m_path, *m_strokeView, *m_workspace.volume()),
        [this, scene](const core::Result<SeenVoxels>& seen) {
            commitSeen(seen, scene);
            m_seenAlong.clear();
        });
}

void SketchTool::commitSeen(const core::Result<SeenVoxels>& seen, const gpu::VolumeScene& scene)
{
    if (!seen)
        return m_workspace.fail(seen.error());
    std::vector<glm::ivec3> voxels;
    for (const auto& pick : *seen) {
        if (!pick)
            continue;
        voxels.push_back(pick->voxel);
        if (const auto along = lookingDirection(scene, pick->piece, m_workspace.volume()->geometry))
            m_seenAlong.emplace_back(pick->voxel, *along);
    }
    if (voxels.empty())
        m_workspace.say(nothingSeenText());
    else
        commit(uniqueVoxels(voxels));
}

void SketchTool::paintSketch(QPainter& painter) const
{
    QPolygonF line;
    for (const glm::dvec2& pixel : m_path.points)
        line.push_back({pixel.x, pixel.y});
    if (line.size() == 1)
        line.push_back(line.front());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 5.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(colour(), 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    // As wide as it is pressed.
    for (std::size_t i = 0; i < m_path.radii.size(); ++i) {
        const QPointF from = line[qsizetype(i == 0 ? 0 : i - 1)];
        const double width = 2.0 * std::max(m_path.radii[i], 1.5);
        painter.setPen(QPen(colour(), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawLine(from, line[qsizetype(i)]);
    }
}

void SketchTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !worksIn(view))
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_strokeView && m_strokeView->view == view.view)
        paintSketch(painter);
    if (!isUnderPointer(view))
        return;
    painter.setPen(QPen(QColor(0, 0, 0, 180), 1.0));
    painter.setBrush(colour());
    painter.drawEllipse(cursor(), 4.0, 4.0);
    drawCursorLabel(painter, view.sizePixels, cursor(), 4.0, cursorLines());
}

} // namespace ui
