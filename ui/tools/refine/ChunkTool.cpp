// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/refine/ChunkTool.h"

#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/refine/ChunkOptions.h"
#include "ui/tools/refine/ChunkRay.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr double stepPixels = 2.0; ///< of a drag, so that no chunk on its way is missed

bool removesOnly(const PointerSample& sample)
{
    return sample.eraserEnd || (sample.modifiers & Qt::ControlModifier);
}

} // namespace

ChunkTool::ChunkTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
{
    // A stroke ends with the chunks it was begun on.
    connect(&workspace, &Workspace::sessionChanged, this, &ChunkTool::forget);
    connect(&workspace.chunks(), &Chunks::changed, this, [this] {
        if (!m_workspace.chunks().map())
            forget();
        Q_EMIT overlayChanged();
    });
    connect(&workspace.chunks(), &Chunks::lookChanged, this, &ChunkTool::forget);
    connect(&workspace, &Workspace::activeToolChanged, this, [this] {
        Chunks::Look look = m_workspace.chunks().look();
        if (m_workspace.activeTool() != this || look.shown || !m_workspace.chunks().division())
            return;
        look.shown = true;
        m_workspace.chunks().setLook(look);
    });
}

QString ChunkTool::name() const
{
    return tr("Chunks");
}

QString ChunkTool::iconName() const
{
    return QStringLiteral("chunks");
}

QString ChunkTool::hint() const
{
    return tr("Chunks: click on one to add it to the segment or to take it away; drag over many");
}

QString ChunkTool::target() const
{
    if (const QString why = whyNot(); !why.isEmpty())
        return why;
    return (m_removes ? tr("takes chunks from %1") : tr("adds chunks to %1, or takes them"))
        .arg(segmentName());
}

QString ChunkTool::keys() const
{
    return tr("[ ] finer, coarser · Ctrl only takes away · Esc cancels");
}

QWidget* ChunkTool::createOptions(QWidget* parent)
{
    return new ChunkOptions(m_workspace, parent);
}

QJsonObject ChunkTool::settingsJson() const
{
    const Chunks::Look& look = m_workspace.chunks().look();
    return {{QStringLiteral("chunks"), look.count},
        {QStringLiteral("opacity"), double(look.opacity)},
        {QStringLiteral("bodies"), int(look.bodies)}};
}

void ChunkTool::applySettings(const QJsonObject& settings)
{
    Chunks::Look look = m_workspace.chunks().look();
    look.count = settings[QStringLiteral("chunks")].toInt(look.count);
    look.opacity = float(settings[QStringLiteral("opacity")].toDouble(look.opacity));
    const int bodies = settings[QStringLiteral("bodies")].toInt(int(look.bodies));
    if (bodies >= int(Chunks::Bodies::Own) && bodies <= int(Chunks::Bodies::All))
        look.bodies = Chunks::Bodies(bodies);
    m_workspace.chunks().setLook(look);
}

bool ChunkTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    // Chunks are bodies of their own, drawn also where the volume is not.
    return !scene || scene->orthographic;
}

QString ChunkTool::segmentName() const
{
    const auto division = m_workspace.chunks().division();
    const core::Segment* segment =
        division ? m_workspace.session()->document().segment(division->segment) : nullptr;
    return segment ? segment->name : QString();
}

QString ChunkTool::whyNot() const
{
    const Chunks& chunks = m_workspace.chunks();
    const auto division = chunks.division();
    if (!division)
        return tr("nothing is divided yet: press Divide in the panel Chunks");
    if (chunks.isWorking())
        return tr("the chunks are being worked out");
    if (!chunks.map())
        return tr("the chunks are not shown: panel Chunks");
    const core::Segment* segment = m_workspace.session()->document().segment(division->segment);
    if (segment && segment->locked)
        return tr("%1 is locked").arg(segment->name);
    return {};
}

QString ChunkTool::chunkText(Chunk chunk) const
{
    const Chunks& chunks = m_workspace.chunks();
    const QString size =
        tr("chunk of %1").arg(volumeText(*m_workspace.volume(), chunks.voxels(chunk)));
    return chunks.has(chunk) ? tr("%1 of %2").arg(size, segmentName()) : size;
}

void ChunkTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !worksIn(view) || m_stroke)
        return;
    if (const QString why = whyNot(); !why.isEmpty())
        return m_workspace.say(tr("Chunks: %1").arg(why));
    const Chunks& chunks = m_workspace.chunks();
    const auto voxel = chunkVoxelUnder(view, sample.position, m_workspace.volume()->geometry);
    const auto chunk = voxel ? chunks.chunkAt(*voxel) : std::nullopt;
    if (!chunk)
        return m_workspace.say(tr("No chunk is there"));
    using Mode = core::ChunkToggle::Mode;
    const bool removes = removesOnly(sample);
    const Mode mode = removes || chunks.has(*chunk) ? Mode::Remove : Mode::Add;
    m_stroke = Stroke{.view = view,
        .last = sample.position,
        .edit = {.segment = chunks.division()->segment, .chunks = chunks.count(), .mode = mode},
        .chunks = {},
        .removes = removes};
    pick(*voxel);
    point(sample.position, view, removes);
}

void ChunkTool::pick(const glm::ivec3& voxel)
{
    const auto chunk = m_workspace.chunks().chunkAt(voxel);
    auto& chunks = m_stroke->chunks;
    if (!chunk || std::find(chunks.begin(), chunks.end(), *chunk) != chunks.end())
        return;
    chunks.push_back(*chunk);
    m_stroke->edit.pointsLps.push_back(m_workspace.volume()->geometry.toWorld(glm::dvec3(voxel)));
    m_workspace.chunks().setLit(chunks);
}

void ChunkTool::follow(const QPointF& to)
{
    const QPointF from = m_stroke->last;
    const QPointF way = to - from;
    const int steps = std::max(1, int(std::ceil(std::hypot(way.x(), way.y()) / stepPixels)));
    for (int i = 1; i <= steps; ++i) {
        const auto voxel = chunkVoxelUnder(
            m_stroke->view, from + way * (double(i) / steps), m_workspace.volume()->geometry);
        if (voxel)
            pick(*voxel);
    }
    m_stroke->last = to;
}

void ChunkTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_stroke || view.view != m_stroke->view.view)
        return;
    follow(sample.position);
    point(sample.position, m_stroke->view, m_removes);
}

void ChunkTool::release(const PointerSample&, const ViewContext&)
{
    if (!m_stroke)
        return;
    Stroke stroke = *std::exchange(m_stroke, std::nullopt);
    // What a click does the engine knows best, whatever is shown.
    if (stroke.chunks.size() == 1 && !stroke.removes)
        stroke.edit.mode = core::ChunkToggle::Mode::Toggle;
    stroke.edit.editable = m_workspace.editableRange();
    m_workspace.chunks().setLit({});
    if (const auto applied = m_workspace.session()->apply(stroke.edit); !applied)
        m_workspace.fail(applied.error());
    Q_EMIT overlayChanged();
}

void ChunkTool::cancel()
{
    const bool began = m_stroke.has_value();
    forget();
    if (began)
        m_workspace.say(tr("No chunk was changed"));
}

void ChunkTool::forget()
{
    m_stroke.reset();
    m_pointed.reset();
    m_workspace.chunks().setLit({});
    Q_EMIT overlayChanged();
}

void ChunkTool::hover(const PointerSample& sample, const ViewContext& view)
{
    if (!m_stroke)
        point(sample.position, view, removesOnly(sample));
}

void ChunkTool::point(const QPointF& pixel, const ViewContext& view, bool removes)
{
    m_removes = removes;
    const Chunks& chunks = m_workspace.chunks();
    const auto voxel = chunks.map() && worksIn(view)
        ? chunkVoxelUnder(view, pixel, m_workspace.volume()->geometry)
        : std::nullopt;
    const auto pointed = voxel ? chunks.chunkAt(*voxel) : std::nullopt;
    if (pointed && pointed != m_pointed)
        m_workspace.say(chunkText(*pointed));
    m_pointed = pointed;
    if (!m_stroke)
        m_workspace.chunks().setLit(
            m_pointed ? std::vector<Chunk>{*m_pointed} : std::vector<Chunk>{});
    showCursor(pixel, view.view);
}

void ChunkTool::leave()
{
    m_pointed.reset();
    if (!m_stroke)
        m_workspace.chunks().setLit({});
    CursorTool::leave();
}

void ChunkTool::changeRadius(int steps)
{
    Chunks::Look look = m_workspace.chunks().look();
    // Larger chunks are fewer.
    look.count = int(std::lround(look.count * std::pow(1.25, -steps)));
    m_workspace.chunks().setLook(look);
}

void ChunkTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !isUnderPointer(view) || !worksIn(view))
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    QStringList lines;
    if (m_stroke) {
        const bool takes = m_stroke->edit.mode == core::ChunkToggle::Mode::Remove;
        const auto count = qlonglong(m_stroke->chunks.size());
        const QString chunks = count == 1 ? tr("one chunk") : tr("%1 chunks").arg(countText(count));
        lines << (takes ? tr("takes %1") : tr("adds %1")).arg(chunks);
    } else if (m_pointed) {
        const bool takes = m_removes || m_workspace.chunks().has(*m_pointed);
        lines << (takes ? tr("takes it from %1") : tr("adds it to %1")).arg(segmentName());
    } else {
        lines << target();
    }
    if (m_pointed)
        lines << chunkText(*m_pointed);
    if (const QString editable = m_workspace.editableText(); !editable.isEmpty())
        lines << editable;
    drawCursorLabel(painter, view.sizePixels, cursor(), 6.0, lines);
}

} // namespace ui
