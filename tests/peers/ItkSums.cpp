// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkSums.h"

#include "tests/peers/ItkBall.h"
#include "tests/peers/ItkImages.h"

#include <itkConstantBoundaryCondition.h>
#include <itkNeighborhoodOperatorImageFilter.h>

#include <array>
#include <cmath>

namespace peer {

namespace {

using Sums = itk::Image<double, 3>;
using Weights = itk::Neighborhood<double, 3>;
using Weighting = itk::NeighborhoodOperatorImageFilter<Sums, Sums, double>;

/// How many voxels of the mask lie in the ball around each.
struct Counted {
    std::vector<double> counts;
    double milliseconds = 0.0;
};

Weights ballOfOnes(const glm::dvec3& spacingMm, double radiusMm)
{
    Weights ball;
    ball.SetRadius(ballRadius(spacingMm, radiusMm));
    for (unsigned at = 0; at < ball.Size(); ++at)
        ball[at] = isInBall(ball.GetOffset(at), spacingMm, radiusMm) ? 1.0 : 0.0;
    return ball;
}

Counted countedIn(const Weights& ball, const GridMask& mask, std::uint8_t side)
{
    std::vector<double> ones(mask.voxels.size());
    for (std::size_t voxel = 0; voxel < ones.size(); ++voxel)
        ones[voxel] = mask.voxels[voxel] == side ? 1.0 : 0.0;
    const auto filter = Weighting::New();
    itk::ConstantBoundaryCondition<Sums> nothing;
    filter->OverrideBoundaryCondition(&nothing);
    filter->SetInput(imageOn<double>(mask.size, mask.spacingMm, ones));
    filter->SetOperator(ball);
    Counted counted;
    counted.milliseconds = timeOf(*filter);
    const double* first = filter->GetOutput()->GetBufferPointer();
    counted.counts.assign(first, first + ones.size());
    return counted;
}

/// @param step of a voxel, in standard deviations
Weights samplesAlong(unsigned axis, double step)
{
    constexpr double reach = 3.0;
    itk::Size<3> radius{{0, 0, 0}};
    radius[axis] = static_cast<itk::SizeValueType>(std::floor(reach / step));
    Weights samples;
    samples.SetRadius(radius);
    double sum = 0.0;
    for (unsigned at = 0; at < samples.Size(); ++at) {
        const double away = double(samples.GetOffset(at)[axis]) * step;
        samples[at] = std::exp(-0.5 * away * away);
        sum += samples[at];
    }
    for (unsigned at = 0; at < samples.Size(); ++at)
        samples[at] /= sum;
    return samples;
}

} // namespace

ItkMask itkMajority(const GridMask& mask, double radiusMm)
{
    const Weights ball = ballOfOnes(mask.spacingMm, radiusMm);
    double whole = 0.0;
    for (unsigned at = 0; at < ball.Size(); ++at)
        whole += ball[at];
    const Counted own = countedIn(ball, mask, 1);
    const Counted rest = countedIn(ball, mask, 0);
    ItkMask voted{.voxels = {mask.voxels.begin(), mask.voxels.end()},
        .milliseconds = own.milliseconds + rest.milliseconds};
    for (std::size_t voxel = 0; voxel < voted.voxels.size(); ++voxel) {
        if (2.0 * own.counts[voxel] > whole)
            voted.voxels[voxel] = 1;
        else if (2.0 * rest.counts[voxel] > whole)
            voted.voxels[voxel] = 0;
    }
    return voted;
}

ItkGaussian itkSampledGaussian(const GridMask& mask, double sigmaMm)
{
    const std::vector<double> values(mask.voxels.begin(), mask.voxels.end());
    const Sums::Pointer image = imageOn<double>(mask.size, mask.spacingMm, values);
    std::array<Weighting::Pointer, 3> filters;
    for (unsigned axis = 0; axis < 3; ++axis) {
        filters.at(axis) = Weighting::New();
        filters.at(axis)->SetOperator(
            samplesAlong(axis, mask.spacingMm[static_cast<int>(axis)] / sigmaMm));
        if (axis == 0)
            filters.at(axis)->SetInput(image);
        else
            filters.at(axis)->SetInput(filters.at(axis - 1)->GetOutput());
    }
    ItkGaussian blurred;
    blurred.milliseconds = timeOf(*filters.back());
    const double* first = filters.back()->GetOutput()->GetBufferPointer();
    blurred.values.assign(first, first + mask.voxels.size());
    return blurred;
}

} // namespace peer
