// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/SketchLook.h"

#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <utility>

namespace ui {

struct SketchLook::Question {
    std::vector<glm::ivec3> seeds;
    core::SketchInterval around;
};

SketchLook::SketchLook(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionClosing, this, &SketchLook::drop);
}

void SketchLook::drop()
{
    ++m_asked;
    m_background.cancel();
}

void SketchLook::ask(std::vector<core::SeedSketch> sketches)
{
    drop();
    const auto choose = [sketches = std::move(sketches),
                            size = m_workspace.volume()->geometry.size] {
        std::vector<glm::ivec3> seeds;
        for (const core::SeedSketch& sketch : sketches)
            seeds.insert(seeds.end(), sketch.voxels.begin(), sketch.voxels.end());
        return std::make_shared<const Question>(
            Question{.seeds = std::move(seeds), .around = {sketches, size}});
    };
    m_background.start(
        this, choose, [this](const core::Result<std::shared_ptr<const Question>>& question) {
            if (question)
                read(*question);
        });
}

void SketchLook::read(std::shared_ptr<const Question> question)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    std::vector<glm::ivec3> voxels = question->seeds;
    voxels.insert(voxels.end(), question->around.voxels().begin(), question->around.voxels().end());
    session->questions().probe(std::move(voxels),
        [look = QPointer<SketchLook>(this), asked = m_asked, question](
            const core::Result<std::vector<core::ProbedVoxel>>& probes) {
            if (!look || look->m_asked != asked || !probes)
                return;
            std::vector<int> codes;
            codes.reserve(probes->size());
            for (const core::ProbedVoxel& probe : *probes)
                codes.push_back(probe.code);
            look->look(question, std::move(codes));
        });
}

void SketchLook::look(std::shared_ptr<const Question> question, std::vector<int> codes)
{
    struct Found {
        core::SketchedCodes sketched;
        std::vector<int> seeds;
    };
    const auto look = [question = std::move(question), codes = std::move(codes)]() mutable {
        const auto seeds = std::ptrdiff_t(question->seeds.size());
        Found result{
            .sketched = question->around.look({codes.begin() + seeds, codes.end()}), .seeds = {}};
        codes.resize(question->seeds.size());
        result.seeds = std::move(codes);
        return result;
    };
    m_background.start(this, look, [this](const core::Result<Found>& result) {
        if (result)
            Q_EMIT found(result->sketched, result->seeds);
    });
}

} // namespace ui
