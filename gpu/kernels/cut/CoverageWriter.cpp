// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/CoverageWriter.h"

#include "gpu/kernels/cut/ProtectedVoxels.h"

#include <algorithm>
#include <iterator>

namespace gpu {

CoverageWriter::CoverageWriter(VoxelFields& fields, BeforeImages& before, const Target& target)
    : m_fields(fields)
    , m_before(before)
    , m_target(target)
{
}

void CoverageWriter::prepare(Program& program) const
{
    program.set("refill", refills());
    setProtected(program, m_fields, m_target.protectedLabels);
}

std::vector<std::uint32_t> CoverageWriter::begin(std::vector<std::uint32_t> candidates)
{
    BrickField& coverage = m_fields.coverage(m_target.layer);
    const auto isEmpty = [&](std::uint32_t brick) { return !coverage.holds(brick); };
    if (refills())
        std::erase_if(candidates, isEmpty); // there is nothing to fill
    m_fresh.clear();
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(m_fresh), isEmpty);
    if (!candidates.empty()) {
        m_before.capture(core::Field::Coverage, m_target.layer, candidates);
        coverage.ensure(candidates);
        coverage.pageTable().bindUnit(1);
        coverage.atlas().bindImage(0, GL_READ_WRITE);
        bindProtected(m_fields, m_target.protectedLabels);
    }
    m_candidates = candidates;
    return candidates;
}

std::vector<std::uint32_t> CoverageWriter::end(const std::vector<std::uint32_t>& flags)
{
    std::vector<std::uint32_t> changed;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] != 0)
            changed.push_back(m_candidates[i]);
    }
    std::vector<std::uint32_t> unused;
    std::set_difference(
        m_fresh.begin(), m_fresh.end(), changed.begin(), changed.end(), std::back_inserter(unused));
    m_fields.coverage(m_target.layer).release(unused);
    m_touched.insert(changed.begin(), changed.end());
    return changed;
}

std::vector<std::uint32_t> CoverageWriter::touchedBricks() const
{
    return {m_touched.begin(), m_touched.end()};
}

} // namespace gpu
