// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/PickQuestion.h"

#include "core/edits/engine/PickRays.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

double opacityAt(const gpu::TransferFunction& function, double value)
{
    const auto& points = function.points;
    if (points.empty())
        return 0.0;
    if (value <= points.front().value)
        return points.front().opacity;
    if (value >= points.back().value)
        return points.back().opacity;
    const auto above = std::upper_bound(points.begin(), points.end(), value,
        [](double v, const gpu::TransferFunction::Point& point) { return v < point.value; });
    const auto below = above - 1;
    const double along = (value - below->value) / (above->value - below->value);
    return below->opacity + (above->opacity - below->opacity) * along;
}

} // namespace

core::OrthographicView orthographicView(const gpu::VolumeScene& scene)
{
    core::OrthographicView view;
    view.eyeLps = scene.eyeLps;
    view.targetLps = scene.targetLps;
    view.up = scene.up;
    view.heightMm = scene.heightMm;
    return view;
}

std::vector<std::uint32_t> opacityOfCodes(
    const gpu::TransferFunction& function, const core::VoxelEncoding& encoding, double sampleMm)
{
    std::vector<std::uint32_t> result(256);
    for (int entry = 0; entry < 256; ++entry) {
        const double perMm =
            std::clamp(opacityAt(function, encoding.value(entry * 256 + 128)), 0.0, 1.0);
        const double perSample = 1.0 - std::pow(1.0 - perMm, sampleMm);
        result[std::size_t(entry)] = std::uint32_t(std::lround(perSample * 65535.0));
    }
    return result;
}

core::PickQuestion pickQuestion(const gpu::VolumeScene& scene,
    const std::vector<glm::dvec2>& planeMm, const core::Volume& volume)
{
    core::PickRays picked =
        core::pickRays(orthographicView(scene), planeMm, volume.geometry, scene.clip);
    core::PickQuestion question;
    question.rays = std::move(picked.rays);
    if (scene.context == gpu::Context::Hidden) {
        question.thresholdCode = core::VoxelEncoding::codeCount; // nothing of it is seen
        return question;
    }
    switch (scene.mode) {
    case gpu::RenderMode::Surface:
        question.seenBy = core::SeenBy::Surface;
        question.thresholdCode = volume.encoding.lowestCodeAtLeast(scene.surfaceThreshold);
        break;
    case gpu::RenderMode::Dvr:
        question.seenBy = core::SeenBy::Opacity;
        question.opacityOfCode =
            opacityOfCodes(scene.transferFunction, volume.encoding, picked.sampleMm);
        break;
    case gpu::RenderMode::Mip:
    case gpu::RenderMode::Xray:
        question.seenBy = core::SeenBy::BrightestVoxel;
        break;
    }
    return question;
}

std::vector<glm::dvec2> alongPath(const std::vector<glm::dvec2>& path, double step)
{
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i > 0) {
            const glm::dvec2 from = path[i - 1];
            const glm::dvec2 way = path[i] - from;
            const int pieces = std::max(1, int(std::ceil(glm::length(way) / step)));
            for (int piece = 1; piece < pieces; ++piece)
                result.push_back(from + way * (double(piece) / pieces));
        }
        result.push_back(path[i]);
    }
    return result;
}

} // namespace ui
