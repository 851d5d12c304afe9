// SPDX-License-Identifier: Apache-2.0
#include "tests/support/DemoHeadScene.h"

#include "core/demo/DemoStudy.h"
#include "core/demo/HeadPhantom.h"
#include "core/refine/InitialFit.h"
#include "tests/support/FrameFixture.h"

namespace test {

namespace {

const core::DemoStudy& study()
{
    static const core::DemoStudy known = [] {
        auto made = core::makeDemoStudy({});
        if (!made)
            qFatal("the demonstration study cannot be made");
        return std::move(*made);
    }();
    return known;
}

/// What fills the skull.
core::BoxMask brain()
{
    std::vector<std::uint8_t> labels;
    labels.reserve(study().parts.size());
    for (const std::uint8_t part : study().parts) {
        const bool inside = part >= std::uint8_t(core::HeadPart::GreyMatter)
            && part <= std::uint8_t(core::HeadPart::Vessels)
            && part != std::uint8_t(core::HeadPart::Membranes);
        labels.push_back(inside ? 1 : 0);
    }
    return core::BoxMask::of(labels, 1, study().geometry.size);
}

} // namespace

void openDemoHead(FrameFixture& fixture)
{
    core::VoxelEncoding encoding;
    encoding.rescaleIntercept = -1024.0;
    std::vector<std::uint16_t> codes;
    codes.reserve(study().hounsfield.size());
    for (const std::int16_t value : study().hounsfield)
        codes.push_back(std::uint16_t(value + 1024));
    if (!fixture.volume.open(study().geometry.size, codes))
        qFatal("the demonstration head cannot be opened");
    fixture.volume.setGeometry(study().geometry, encoding);
}

core::SimplexMesh demoBrain()
{
    auto mesh = core::initialFit(brain(), study().geometry, {.vertices = 20'000, .steps = 15}, {});
    if (!mesh)
        qFatal("no surface can be laid around the brain");
    core::SimplexMeshEdit edit(*mesh);
    for (const core::VertexId id : mesh->vertexIds()) {
        const glm::dvec3& place = mesh->position(id);
        if (place.z > 45.0)
            edit.setMark(id, core::SurfaceMark::Green);
        if (glm::length(place - glm::dvec3(-45.0, -45.0, 10.0)) < 22.0)
            edit.setMark(id, core::SurfaceMark::Red);
    }
    (void)edit.commit();
    return std::move(*mesh);
}

gpu::VolumeScene demoHeadScene()
{
    gpu::VolumeScene view;
    view.eyeLps = {-260.0, -430.0, 110.0};
    view.heightMm = 240.0;
    view.surfaceThreshold = 300.0;
    view.transferFunction.points = {{150.0, 0x8a4b32, 0.0}, {250.0, 0xd9a066, 0.05},
        {600.0, 0xf2e4c4, 0.35}, {1800.0, 0xffffff, 0.8}};
    view.mipWindow = {700.0, 1800.0};
    view.xrayWindow = {200.0, 1400.0};
    view.cutFaces = gpu::CutFaces::GreyValues;
    view.faceWindow = {60.0, 400.0};
    view.clip.planes[0] = {.pointLps = {-12.0, -10.0, 0.0},
        .normalLps = glm::normalize(glm::dvec3(-1.0, -0.8, 0.25)),
        .on = true};
    return view;
}

} // namespace test
