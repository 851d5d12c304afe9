// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/PinholeOffer.h"

#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/session/EditSession.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <optional>
#include <utility>
#include <vector>

namespace ui {

namespace {

/// How many voxels are in pinholes and are nobody's.
core::Result<std::int64_t> pinholeVoxels(const std::vector<std::uint8_t>& labels,
    const glm::ivec3& size, std::uint8_t label, const core::Progress& progress)
{
    const auto holes = core::islandChange(
        labels, size, label, core::IslandRule::FillHoles, PinholeOffer::mostVoxels, progress);
    if (!holes)
        return tl::unexpected(holes.error());
    std::int64_t count = 0;
    for (const core::VoxelRun& run : holes->voxels.runs()) {
        for (std::uint64_t at = run.first; at < run.first + run.count; ++at)
            count += labels[std::size_t(at)] == 0 ? 1 : 0;
    }
    return count;
}

constexpr double smallestVoxelMm3 = 1e-4;

/// What CleanSegment takes for a voxel's volume: on a sheared grid it is more than that.
double edgesProduct(const core::VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    return spacing.x * spacing.y * spacing.z;
}

} // namespace

struct PinholeOffer::Look {
    int label = 0;
    std::shared_ptr<core::LabelReader> reader;
    std::optional<core::RowId> position{}; ///< of the history; none: before the first answer
};

PinholeOffer::PinholeOffer(Workspace& workspace, QWidget* parent)
    : QLabel(parent)
    , m_workspace(workspace)
{
    setObjectName(QStringLiteral("growPinholes"));
    setFont(theme::smallFont());
    setWordWrap(true);
    setTextFormat(Qt::RichText);
    hide();
    connect(this, &QLabel::linkActivated, this, &PinholeOffer::fill);
    connect(&workspace, &Workspace::sessionClosing, this, &PinholeOffer::forget);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History)
                follow();
        });
}

void PinholeOffer::forget()
{
    m_background.cancel();
    m_look.reset();
    hide();
}

/// What was found is true of one position of the history.
void PinholeOffer::follow()
{
    if (m_look && m_look->position
        && *m_look->position != m_workspace.session()->history().position())
        forget();
}

void PinholeOffer::lookInto(int label)
{
    forget();
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(label) : nullptr;
    if (!segment || segment->locked)
        return;
    // The edit holds cubic millimetres in steps of 2⁻²⁰, which cannot say how many such voxels.
    if (edgesProduct(session->document().volumes.front().geometry) < smallestVoxelMm3)
        return;
    m_look = std::make_shared<Look>(Look{.label = label,
        .reader = std::make_shared<core::LabelReader>(
            session->document().volumes.front().geometry.size, segment->plane)});
    readOn();
}

void PinholeOffer::readOn()
{
    const auto take = [offer = QPointer<PinholeOffer>(this), asked = std::weak_ptr<Look>(m_look)](
                          const core::Result<void>& portion) {
        if (!offer || !offer->m_look || offer->m_look != asked.lock())
            return;
        const core::EditSession& session = *offer->m_workspace.session();
        offer->m_look->position = session.history().position();
        // Of a growth that runs again they would be something in between.
        if (!portion || session.transactionOpen())
            offer->forget();
        else
            offer->readOn();
    };
    if (!m_workspace.session()->questions().readOn(m_look->reader, take))
        search();
}

void PinholeOffer::search()
{
    m_background.replace(
        this,
        [reader = m_look->reader, label = m_look->label,
            size = m_workspace.volume()->geometry.size](const core::Progress& progress) {
            return pinholeVoxels(reader->takeLabels(), size, std::uint8_t(label), progress);
        },
        [this, label = m_look->label](const core::Result<std::int64_t>& voxels) {
            if (voxels && *voxels > 0)
                offer(label, *voxels);
            else
                forget();
        });
}

void PinholeOffer::offer(int label, std::int64_t voxels)
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(label) : nullptr;
    if (!segment)
        return forget();
    const QString link = QStringLiteral("<a href=\"fill\" style=\"color: %1\">%2</a>")
                             .arg(theme::accent.name(), tr("Fill\u00a0holes"));
    const QString name = segment->name.toHtmlEscaped();
    setText(voxels == 1 ? tr("One voxel inside '%1' was left out. %2").arg(name, link)
                        : tr("%1 voxels inside '%2' were left out, in small holes. %3")
                              .arg(countText(voxels), name, link));
    show();
}

void PinholeOffer::fill()
{
    core::EditSession* session = m_workspace.session();
    if (!session || !m_look)
        return;
    // Half a voxel more, so that rounding decides nothing.
    const double mm3 = (double(mostVoxels) + 0.5) * edgesProduct(m_workspace.volume()->geometry);
    const core::CleanSegment edit{
        .segment = m_look->label, .rule = core::IslandRule::FillHoles, .mm3 = mm3};
    forget();
    if (const auto applied = session->apply(edit); !applied)
        m_workspace.fail(applied.error());
}

} // namespace ui
