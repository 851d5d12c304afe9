// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/outline/ReadSlice.h"

#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

constexpr std::size_t voxelsAtOnce = 1 << 16; ///< so that frames come between

} // namespace

/// The voxels of an oblique slice, and what is known of them so far.
struct ReadSlice::Portions {
    std::vector<std::vector<glm::ivec3>> voxels;
    std::vector<std::vector<core::ProbedVoxel>> answers;
};

ReadSlice::ReadSlice(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionClosing, this, &ReadSlice::drop);
}

void ReadSlice::drop()
{
    ++m_asked;
    m_background.cancel();
    m_lattice = {};
    m_pixels.reset();
    Q_EMIT dropped();
}

void ReadSlice::look(const ViewContext& view)
{
    const auto* scene = std::get_if<gpu::SliceScene>(&view.scene);
    if (!scene || !m_workspace.session())
        return;
    const core::SliceLattice lattice = core::sliceLattice(
        m_workspace.volume()->geometry, scene->centreLps, scene->rightLps, scene->downLps);
    if (lattice.isAt(m_lattice))
        return;
    drop();
    m_lattice = lattice;
    if (lattice.empty())
        return;
    if (lattice.box)
        readBox();
    else
        chooseVoxels();
}

void ReadSlice::readBox()
{
    m_workspace.session()->questions().codes(*m_lattice.box,
        [self = QPointer(this), asked = m_asked](core::Result<std::vector<std::uint16_t>> codes) {
            if (!self || self->m_asked != asked)
                return;
            if (!codes)
                return self->fail(codes.error());
            self->take(std::make_shared<const core::SlicePixels>(
                core::SlicePixels{.size = self->m_lattice.size, .codes = *std::move(codes)}));
        });
}

void ReadSlice::chooseVoxels()
{
    using Chosen = std::vector<std::vector<glm::ivec3>>;
    const auto choose = [lattice = m_lattice, geometry = m_workspace.volume()->geometry] {
        const std::vector<glm::ivec3> voxels = core::nearestVoxels(lattice, geometry);
        Chosen portions;
        for (std::size_t first = 0; first < voxels.size(); first += voxelsAtOnce) {
            const std::size_t last = std::min(voxels.size(), first + voxelsAtOnce);
            portions.emplace_back(
                voxels.begin() + std::ptrdiff_t(first), voxels.begin() + std::ptrdiff_t(last));
        }
        return portions;
    };
    m_background.start(this, choose, [this](core::Result<Chosen> portions) {
        if (portions)
            readOn(std::make_shared<Portions>(Portions{.voxels = *std::move(portions)}));
        else
            fail(portions.error());
    });
}

void ReadSlice::readOn(const std::shared_ptr<Portions>& portions)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    std::vector<glm::ivec3> voxels = std::move(portions->voxels[portions->answers.size()]);
    session->questions().probe(std::move(voxels),
        [self = QPointer(this), asked = m_asked, portions](
            core::Result<std::vector<core::ProbedVoxel>> probes) {
            if (!self || self->m_asked != asked)
                return;
            if (!probes)
                return self->fail(probes.error());
            portions->answers.push_back(*std::move(probes));
            if (portions->answers.size() < portions->voxels.size())
                self->readOn(portions);
            else
                self->putInOrder(portions);
        });
}

void ReadSlice::putInOrder(const std::shared_ptr<Portions>& portions)
{
    const auto order = [portions, size = m_lattice.size] {
        auto pixels = std::make_shared<core::SlicePixels>(core::SlicePixels{.size = size});
        pixels->codes.reserve(std::size_t(size.x) * std::size_t(size.y));
        for (const std::vector<core::ProbedVoxel>& portion : portions->answers) {
            for (const core::ProbedVoxel& voxel : portion)
                pixels->codes.push_back(std::uint16_t(voxel.code));
        }
        return std::shared_ptr<const core::SlicePixels>(std::move(pixels));
    };
    using Pixels = std::shared_ptr<const core::SlicePixels>;
    m_background.start(this, order, [this](core::Result<Pixels> pixels) {
        if (pixels)
            take(*std::move(pixels));
        else
            fail(pixels.error());
    });
}

void ReadSlice::take(std::shared_ptr<const core::SlicePixels> pixels)
{
    m_pixels = std::move(pixels);
    Q_EMIT arrived();
}

void ReadSlice::fail(const core::Error& error)
{
    drop();
    m_workspace.fail(error);
}

} // namespace ui
