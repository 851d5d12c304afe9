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

GrowthPrograms::GrowthPrograms(const ShaderLibrary& shaders)
    : placeSeeds(program(shaders, "kernels/growth/placeSeeds.comp"))
    , seedStatistics(shaders)
    , shrink(shaders)
    , passage(shaders)
    , m_shaders(shaders)
{
    (void)rings({});
}

GrowthPrograms::Kind GrowthPrograms::keyOf(const GrowthKind& kind)
{
    return {unsigned(kind.connectivity), kindOf(kind.limits), kind.overwritten ? 1u : 0u};
}

GrowthPrograms::Rings& GrowthPrograms::rings(const GrowthKind& kind)
{
    const auto known = m_rings.find(keyOf(kind));
    if (known != m_rings.end())
        return known->second;
    return m_rings.try_emplace(keyOf(kind), m_shaders, kind, false).first->second;
}

GrowthPrograms::Narrowing& GrowthPrograms::narrowing(const GrowthKind& kind)
{
    const auto known = m_narrowings.find(keyOf(kind));
    if (known != m_narrowings.end())
        return known->second;
    return m_narrowings.try_emplace(keyOf(kind), m_shaders, kind).first->second;
}

FrontBitsPrograms& GrowthPrograms::frontBits(const GrowthKind& kind)
{
    const auto known = m_frontBits.find(keyOf(kind));
    if (known != m_frontBits.end())
        return known->second;
    return m_frontBits
        .try_emplace(keyOf(kind), m_shaders, kind.connectivity, kind.limits, kind.overwritten)
        .first->second;
}

} // namespace gpu
