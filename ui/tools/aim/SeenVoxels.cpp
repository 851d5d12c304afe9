// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/SeenVoxels.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "core/edits/engine/PickRays.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/tools/aim/PickQuestion.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace ui {

namespace {

struct Sample {
    glm::ivec3 voxel{0};
    double depthMm = 0.0; ///< behind the target's plane, as shown
    int code = 0;
};

/// A point's way through one piece, or through the segments if it has the id 0; samples that are no
/// voxel of it are taken out.
struct Way {
    std::size_t point = 0;
    gpu::ScenePiece piece;
    std::vector<std::uint8_t> planes; ///< the label planes, or the layer, that may hold it
    double sampleMm = 0.0; ///< at the true place
    std::vector<Sample> samples;
};

struct Question {
    gpu::VolumeScene scene;
    core::Volume volume; ///< its description
    std::array<bool, 256> segments{}; ///< labels that are shown
    SeenVoxels seen; ///< of the rest of the volume
    std::vector<double> depthMm;
    std::vector<Way> ways;
    std::vector<bool> onSegment; ///< points where a segment that is shown alone is met
    /// The second one is onSegment.
    std::function<void(const core::Result<SeenVoxels>&, const std::vector<bool>&)> then;

    void fail(const core::Error& error) const { then(tl::unexpected(error), onSegment); }
    void finish(const SeenVoxels& found) const { then(found, onSegment); }
};

glm::dvec3 forwardOf(const gpu::VolumeScene& scene)
{
    return glm::normalize(scene.targetLps - scene.eyeLps);
}

/// What may hold a piece, or the segments if it has the id 0: its layer, or label planes.
std::vector<std::uint8_t> planesOf(const gpu::ScenePiece& piece, const core::Document& document)
{
    if (piece.layer > 0)
        return {std::uint8_t(piece.layer)};
    if (piece.id == 0)
        return document.labelPlanes();
    const core::Segment* its = document.segment(piece.segment);
    return {its ? its->plane : std::uint8_t(0)};
}

core::BrickKey keyOf(const gpu::ScenePiece& piece, std::uint8_t plane, std::uint32_t brick)
{
    return {.field = piece.layer > 0 ? core::Field::Coverage : core::Field::Labels,
        .plane = plane,
        .brick = brick};
}

/// Adds the ways of all points through a piece, as if it were at home and the viewer moved.
void addWays(std::vector<Way>& ways, const gpu::ScenePiece& piece, const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm, const core::Document& document)
{
    const core::Volume& volume = document.volumes.front();
    const double zoom = std::cbrt(std::abs(glm::determinant(glm::dmat3(piece.shownFromTrue))));
    const glm::dmat4 toTrue = glm::inverse(piece.shownFromTrue);
    core::OrthographicView view = orthographicView(scene);
    view.eyeLps = glm::dvec3(toTrue * glm::dvec4(view.eyeLps, 1.0));
    view.targetLps = glm::dvec3(toTrue * glm::dvec4(view.targetLps, 1.0));
    view.up = glm::normalize(glm::dmat3(toTrue) * view.up);
    std::vector<glm::dvec2> points = planeMm;
    for (glm::dvec2& point : points)
        point /= zoom;
    const core::PickRays picked = core::pickRays(view, points, volume.geometry, scene.clip);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const core::PickRay& ray = picked.rays[i];
        Way way{.point = i,
            .piece = piece,
            .planes = planesOf(piece, document),
            .sampleMm = picked.sampleMm,
            .samples = {}};
        for (int n = 0; n < ray.samples; ++n) {
            const glm::dvec3 index = glm::dvec3(ray.origin + ray.step * n) / 65536.0;
            const glm::dvec3 shown(
                piece.shownFromTrue * glm::dvec4(volume.geometry.toWorld(index), 1.0));
            const glm::ivec3 voxel(glm::round(index));
            if (volume.geometry.contains(voxel))
                way.samples.push_back({.voxel = voxel,
                    .depthMm = glm::dot(shown - scene.targetLps, forwardOf(scene))});
        }
        if (!way.samples.empty())
            ways.push_back(std::move(way));
    }
}

/// The ways of all points through all shown pieces. Segments that are shown alone are one of them,
/// whose id is 0.
std::vector<Way> waysThrough(const gpu::VolumeScene& scene, const std::vector<glm::dvec2>& planeMm,
    const core::Document& document)
{
    std::vector<Way> ways;
    for (const gpu::ScenePiece& piece : scene.pieces) {
        if (piece.opacity > 0.0f && piece.id != 0)
            addWays(ways, piece, scene, planeMm, document);
    }
    if (scene.context == gpu::Context::Hidden)
        addWays(ways, {.solid = true}, scene, planeMm, document);
    return ways;
}

/// Takes out what does not belong to the piece.
void keepMembers(
    Question& question, const std::vector<core::BrickImage>& bricks, const core::BrickGrid& grid)
{
    std::vector<Way>& ways = question.ways;
    std::map<core::BrickKey, const std::vector<std::uint8_t>*> known;
    for (const core::BrickImage& brick : bricks)
        known[brick.key] = &brick.bytes.read();
    for (Way& way : ways) {
        const auto isMember = [&](const Sample& sample, std::uint8_t plane) {
            const int brick = grid.brickOf(sample.voxel);
            const auto found = known.find(keyOf(way.piece, plane, std::uint32_t(brick)));
            if (found == known.end() || found->second->empty())
                return false;
            const glm::ivec3 local =
                sample.voxel - grid.brickPosition(brick) * core::BrickGrid::side;
            const int value = (*found->second)[std::size_t(
                local.x + core::BrickGrid::side * (local.y + core::BrickGrid::side * local.z))];
            if (way.piece.id == 0)
                return value != 0 && question.segments[std::size_t(value)];
            return way.piece.layer > 0 ? value >= 128 : value == way.piece.segment;
        };
        std::erase_if(way.samples, [&](const Sample& sample) {
            return std::ranges::none_of(
                way.planes, [&](std::uint8_t plane) { return isMember(sample, plane); });
        });
    }
    std::erase_if(ways, [](const Way& way) { return way.samples.empty(); });
    for (const Way& way : ways) {
        if (way.piece.id == 0)
            question.onSegment[way.point] = true;
    }
}

/// What of a piece is seen on a way, as the mode draws it; null: nothing.
const Sample* seenOf(const Way& way, const Question& question)
{
    const core::VoxelEncoding& encoding = question.volume.encoding;
    const gpu::VolumeScene& scene = question.scene;
    const bool shaded =
        scene.mode == gpu::RenderMode::Surface || scene.mode == gpu::RenderMode::Dvr;
    if (way.piece.solid && shaded)
        return &way.samples.front();
    if (scene.mode == gpu::RenderMode::Surface) {
        const int threshold = encoding.lowestCodeAtLeast(scene.surfaceThreshold);
        for (const Sample& sample : way.samples) {
            if (sample.code >= threshold)
                return &sample;
        }
        return nullptr;
    }
    if (scene.mode == gpu::RenderMode::Dvr) {
        const bool own = !way.piece.transferFunction.points.empty();
        const std::vector<std::uint32_t> opacity = opacityOfCodes(
            own ? way.piece.transferFunction : scene.transferFunction, encoding, way.sampleMm);
        double through = 1.0;
        for (const Sample& sample : way.samples) {
            through *=
                1.0 - double(way.piece.opacity) * opacity[std::size_t(sample.code) >> 8] / 65535.0;
            if (through <= 0.5)
                return &sample;
        }
        return nullptr;
    }
    const Sample* brightest = &way.samples.front();
    for (const Sample& sample : way.samples) {
        if (sample.code > brightest->code)
            brightest = &sample;
    }
    return brightest;
}

/// @param codes of the rest's voxels, one per point
void choose(Question& question, const std::vector<int>& codes)
{
    SeenVoxels seen = question.seen;
    std::vector<double> depth = question.depthMm;
    std::vector<int> brightness = codes;
    const bool shaded = question.scene.mode == gpu::RenderMode::Surface
        || question.scene.mode == gpu::RenderMode::Dvr;
    for (const Way& way : question.ways) {
        const Sample* sample = seenOf(way, question);
        if (!sample)
            continue;
        const bool wins = !seen[way.point]
            || (shaded ? sample->depthMm < depth[way.point] : sample->code > brightness[way.point]);
        if (!wins)
            continue;
        seen[way.point] = SeenVoxel{sample->voxel, way.piece.id};
        depth[way.point] = sample->depthMm;
        brightness[way.point] = sample->code;
    }
    question.finish(seen);
}

void askCodes(Workspace& workspace, const std::shared_ptr<Question>& question)
{
    std::vector<glm::ivec3> voxels;
    for (const Way& way : question->ways) {
        for (const Sample& sample : way.samples)
            voxels.push_back(sample.voxel);
    }
    for (const auto& voxel : question->seen)
        voxels.push_back(voxel.value_or(SeenVoxel()).voxel);
    using Probes = std::vector<core::ProbedVoxel>;
    const auto take = [question](const core::Result<Probes>& probes) {
        if (!probes)
            return question->fail(probes.error());
        std::size_t next = 0;
        for (Way& way : question->ways) {
            for (Sample& sample : way.samples)
                sample.code = (*probes)[next++].code;
        }
        std::vector<int> codes;
        while (next < probes->size())
            codes.push_back((*probes)[next++].code);
        choose(*question, codes);
    };
    workspace.session()->questions().probe(std::move(voxels), take);
}

void askMembers(Workspace& workspace, const std::shared_ptr<Question>& question)
{
    const core::BrickGrid grid{question->volume.geometry.size};
    std::set<core::BrickKey> keys;
    for (const Way& way : question->ways) {
        for (const Sample& sample : way.samples) {
            for (const std::uint8_t plane : way.planes)
                keys.insert(keyOf(way.piece, plane, std::uint32_t(grid.brickOf(sample.voxel))));
        }
    }
    workspace.session()->questions().bricks({keys.begin(), keys.end()},
        [&workspace, question, grid](const core::Result<std::vector<core::BrickImage>>& bricks) {
            if (!bricks)
                return question->fail(bricks.error());
            {
                const core::VoxelsAllowed singleOnes; // those on the ways, some thousand at most
                keepMembers(*question, *bricks, grid);
            }
            if (question->ways.empty())
                return question->finish(question->seen);
            askCodes(workspace, question);
        });
}

void askQuestion(Workspace& workspace, const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm,
    const std::function<void(const core::Result<SeenVoxels>&, const std::vector<bool>&)>& then)
{
    auto question = std::make_shared<Question>();
    question->scene = scene;
    if (scene.context == gpu::Context::Hidden)
        question->scene.mode = gpu::RenderMode::Surface; // as it is drawn in every mode
    question->segments = workspace.segmentDisplay().visible;
    question->volume = *workspace.volume();
    question->ways = waysThrough(scene, planeMm, workspace.session()->document());
    question->onSegment.assign(planeMm.size(), false);
    question->then = then;
    workspace.session()->questions().pick(pickQuestion(scene, planeMm, *workspace.volume()),
        [&workspace, question](const core::Result<PickedVoxels>& picked) {
            if (!picked)
                return question->fail(picked.error());
            question->seen.clear();
            for (const std::optional<glm::ivec3>& voxel : *picked)
                question->seen.push_back(
                    voxel ? std::optional<SeenVoxel>({.voxel = *voxel}) : std::nullopt);
            for (const auto& voxel : question->seen) {
                const glm::dvec3 lps = question->volume.geometry.toWorld(
                    glm::dvec3(voxel.value_or(SeenVoxel()).voxel));
                question->depthMm.push_back(
                    glm::dot(lps - question->scene.targetLps, forwardOf(question->scene)));
            }
            if (question->ways.empty())
                return question->finish(question->seen);
            askMembers(workspace, question);
        });
}

/// Whether the volume steps back for segments, but is drawn.
bool stepsBack(const gpu::VolumeScene& scene)
{
    return scene.context == gpu::Context::CutAway
        || (scene.context == gpu::Context::Translucent && scene.contextOpacity < 1.0f);
}

} // namespace

void askWhatIsSeen(Workspace& workspace, const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm,
    const std::function<void(const core::Result<SeenVoxels>&)>& then)
{
    askQuestion(workspace, scene, planeMm,
        [then](const core::Result<SeenVoxels>& seen, const std::vector<bool>&) { then(seen); });
}

void askWhatIsPointedAt(Workspace& workspace, const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm,
    const std::function<void(const core::Result<SeenVoxels>&)>& then)
{
    if (!stepsBack(scene))
        return askWhatIsSeen(workspace, scene, planeMm, then);
    gpu::VolumeScene alone = scene;
    alone.context = gpu::Context::Hidden;
    gpu::VolumeScene whole = scene;
    whole.context = gpu::Context::Opaque;
    askQuestion(workspace, alone, planeMm,
        [&workspace, whole, planeMm, then](
            const core::Result<SeenVoxels>& segments, const std::vector<bool>& onSegment) {
            if (!segments)
                return then(tl::unexpected(segments.error()));
            std::vector<glm::dvec2> others;
            for (std::size_t point = 0; point < planeMm.size(); ++point) {
                if (!onSegment[point])
                    others.push_back(planeMm[point]);
            }
            if (others.empty())
                return then(segments);
            askWhatIsSeen(workspace, whole, others,
                [found = *segments, onSegment, then](const core::Result<SeenVoxels>& rest) {
                    if (!rest)
                        return then(tl::unexpected(rest.error()));
                    SeenVoxels all = found;
                    std::size_t next = 0;
                    for (std::size_t point = 0; point < all.size(); ++point) {
                        if (!onSegment[point])
                            all[point] = (*rest)[next++];
                    }
                    then(all);
                });
        });
}

} // namespace ui
