// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/shrink/CutPreviewer.h"

#include "core/growth/cut/CutPreview.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/gl/GlFailure.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <new>
#include <utility>
#include <vector>

namespace gpu {

namespace {

constexpr std::chrono::milliseconds slice(8); ///< of the engine's thread, for reading words
constexpr std::size_t bricksAtOnce = 32;

} // namespace

struct CutPreviewer::Ground {
    std::uint8_t plane = 0;
    core::BrickGrid grid;
    std::vector<std::uint32_t> bricks; ///< ascending; those with words
    std::vector<std::vector<std::uint8_t>> images; ///< until the worker has made words of them
    std::vector<std::vector<std::uint8_t>> labels;
    std::optional<core::WordBricks> words; ///< the worker's, like the next
    bool isMade = false; ///< words are whole

    [[nodiscard]] bool whole() const { return labels.size() == bricks.size(); }
    [[nodiscard]] const std::vector<std::uint8_t>& labelsOf(std::uint32_t brick) const
    {
        const auto place = std::lower_bound(bricks.begin(), bricks.end(), brick);
        return labels[std::size_t(place - bricks.begin())];
    }
    void makeWords()
    {
        // Memory ran out over it at an earlier question, which nobody has looked at since; what it
        // was made of is gone in part.
        if (words)
            throw std::bad_alloc();
        words.emplace(grid, bricks.size());
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            if (!images[i].empty())
                words->add(bricks[i], images[i]);
            images[i] = {};
        }
        words->link();
        isMade = true;
    }
};

struct CutPreviewer::Work {
    core::CutGrowth cut;
    core::CutPreview preview; ///< the worker's until it is done
    std::optional<core::Error> refused; ///< likewise
    bool posted = false;
    std::optional<core::Error> failed; ///< likewise
    std::atomic<bool> done = false;
    std::atomic<bool> unwanted = false;
};

CutPreviewer::CutPreviewer(VolumeTextures& textures)
    : m_marks(textures)
{
}

CutPreviewer::~CutPreviewer()
{
    forget();
}

core::Result<std::optional<core::CutPreview>> CutPreviewer::ask(
    VoxelFields& fields, const core::PreviewCut& question)
{
    if (m_ground && m_ground->plane != question.cut.plane)
        forget();
    if (!m_work || m_work->cut != question.cut) {
        if (m_work)
            m_work->unwanted = true;
        m_answer.reset();
        m_refused.reset();
        m_work = std::make_shared<Work>();
        m_work->cut = question.cut;
    }
    if (m_refused)
        return tl::unexpected(*m_refused);
    if (m_answer)
        return m_answer;
    if (!read(fields, question.cut.plane, question.toTheEnd))
        return std::nullopt;
    if (!m_work->posted)
        post();
    if (question.toTheEnd)
        m_worker->finish();
    if (!m_work->done)
        return std::nullopt;
    if (m_work->failed)
        throw GlFailure(*m_work->failed);
    m_answer = m_work->preview;
    m_refused = m_work->refused;
    show(fields);
    if (m_refused)
        return tl::unexpected(*m_refused);
    return m_answer;
}

bool CutPreviewer::read(VoxelFields& fields, std::uint8_t plane, bool toTheEnd)
{
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    if (!m_ground) {
        m_ground = std::make_shared<Ground>();
        m_ground->plane = plane;
        m_ground->grid = fields.grid();
        m_ground->bricks = fields.seedWords(plane).heldBricks();
    }
    while (!m_ground->whole() && (toTheEnd || Clock::now() - start < slice)) {
        const std::size_t done = m_ground->labels.size();
        const std::span<const std::uint32_t> next =
            std::span(m_ground->bricks)
                .subspan(done, std::min(bricksAtOnce, m_ground->bricks.size() - done));
        for (const core::Field field : {core::Field::SeedWords, core::Field::Labels}) {
            auto& all = field == core::Field::Labels ? m_ground->labels : m_ground->images;
            auto images = fields.copier().images(fields.textures(field, plane), next);
            std::move(images.begin(), images.end(), std::back_inserter(all));
        }
    }
    return m_ground->whole();
}

void CutPreviewer::post()
{
    m_work->posted = true;
    if (!m_worker)
        m_worker.emplace();
    m_worker->post(
        [ground = m_ground, work = m_work] {
            if (work->unwanted)
                return;
            if (!ground->isMade)
                ground->makeWords();
            const auto leaving = core::leavingBricks(*ground->words, work->cut);
            if (leaving) {
                std::vector<std::vector<std::uint8_t>> held;
                for (const core::LeavingBricks::Brick& brick : leaving->bricks)
                    held.push_back(ground->labelsOf(brick.brick));
                work->preview = core::cutPreview(*leaving, held);
            } else {
                work->refused = leaving.error();
            }
            work->done = true;
        },
        [work = m_work](const core::Error& error) {
            work->failed = error;
            work->done = true;
        });
}

void CutPreviewer::show(VoxelFields& fields)
{
    std::vector<PreviewMarks::Brick> bricks;
    bricks.reserve(m_answer->bricks.size());
    for (const core::CutPreview::Brick& brick : m_answer->bricks) {
        std::vector<std::uint8_t> marks(brick.taken.size(), PreviewMarks::None);
        for (std::size_t voxel = 0; voxel < marks.size(); ++voxel) {
            if (brick.taken[voxel])
                marks[voxel] = PreviewMarks::Goes;
        }
        bricks.push_back({.brick = brick.brick, .marks = std::move(marks)});
    }
    m_marks.show(fields, std::move(bricks), m_work->cut.plane);
}

void CutPreviewer::forget()
{
    if (m_work)
        m_work->unwanted = true;
    m_work.reset();
    m_answer.reset();
    m_refused.reset();
    m_ground.reset();
    m_marks.hide();
}

std::size_t CutPreviewer::bytes() const
{
    return m_marks.bytes();
}

} // namespace gpu
