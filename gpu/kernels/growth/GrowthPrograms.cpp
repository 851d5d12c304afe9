// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/growth/GrowthKernel.h"

namespace gpu {

namespace {

Program program(const ShaderLibrary& library, const char* path, const ShaderDefines& defines = {})
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

} // namespace

ShaderDefines GrowthKind::defines() const
{
    ShaderDefines defines = definesOf(limits);
    if (overwritten)
        defines.emplace_back("OVERWRITTEN", 1);
    if (ranged)
        defines.emplace_back("RANGE", 1);
    return defines;
}

GrowthPrograms::Rings::Rings(const ShaderLibrary& shaders, const GrowthKind& kind, bool back)
{
    ShaderDefines defines = kind.defines();
    if (!back) {
        admit = program(shaders, "kernels/growth/growAdmit.comp", defines);
        label = program(shaders, "kernels/growth/growLabel.comp", defines);
    }
    defines.emplace_back("CONNECTIVITY", kind.connectivity);
    if (back)
        defines.emplace_back("BACK", 1);
    front = program(shaders, "kernels/growth/growFront.comp", defines);
    // A front that cannot pass costs one look more, once; so only rings ask.
    if (core::isAsked(kind.limits.passage) && !back)
        defines.emplace_back("PASSAGE", 1);
    ring = program(shaders, "kernels/growth/growRing.comp", defines);
    defines.emplace_back("SEVERAL_RINGS", 1);
    severalRings = program(shaders, "kernels/growth/growRing.comp", defines);
}

GrowthPrograms::Narrowing::Narrowing(const ShaderLibrary& shaders, const GrowthKind& kind)
    : back(shaders, kind, true)
{
    ShaderDefines defines = kind.defines();
    doubt = program(shaders, "kernels/growth/growDoubt.comp", defines);
    defines.emplace_back("CONNECTIVITY", kind.connectivity);
    sweep = program(shaders, "kernels/growth/growSweep.comp", defines);
}

GrowthPrograms::GrowthPrograms(const ShaderLibrary& shaders, WorkBy by)
    : placeSeeds(program(shaders, "kernels/growth/placeSeeds.comp"))
    , seedStatistics(shaders)
    , shrink(shaders)
    , passage(shaders)
    , m_shaders(shaders)
    , m_growsOnProcessor(isByProcessor(by))
{
}

GrowthPrograms::Kind GrowthPrograms::keyOf(const GrowthKind& kind)
{
    return {unsigned(kind.connectivity), kindOf(kind.limits),
        (kind.overwritten ? 1u : 0u) | (kind.ranged ? 2u : 0u)};
}

std::shared_ptr<GrowthPrograms::Rings> GrowthPrograms::rings(const GrowthKind& kind)
{
    return m_rings.of(keyOf(kind), [&] { return std::make_shared<Rings>(m_shaders, kind, false); });
}

std::shared_ptr<GrowthPrograms::Narrowing> GrowthPrograms::narrowing(const GrowthKind& kind)
{
    return m_narrowings.of(
        keyOf(kind), [&] { return std::make_shared<Narrowing>(m_shaders, kind); });
}

std::shared_ptr<FrontBitsPrograms> GrowthPrograms::frontBits(const GrowthKind& kind)
{
    return m_frontBits.of(keyOf(kind), [&] {
        return std::make_shared<FrontBitsPrograms>(
            m_shaders, kind.connectivity, kind.limits, kind.overwritten, kind.ranged);
    });
}

std::shared_ptr<Program> GrowthPrograms::openBits(const GrowthKind& kind)
{
    return m_openBits.of(keyOf(kind), [&] {
        return std::make_shared<Program>(openBitsProgram(m_shaders, kind.limits, kind.ranged));
    });
}

std::shared_ptr<Program> GrowthPrograms::change(bool overwritten)
{
    return m_changes.of(overwritten, [&] {
        return std::make_shared<Program>(program(m_shaders, "kernels/growth/growChange.comp",
            GrowthKind{.overwritten = overwritten}.defines()));
    });
}

} // namespace gpu
