// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkMorphology.h"

#include "tests/peers/ItkBall.h"
#include "tests/peers/ItkImages.h"

#include <itkBinaryDilateImageFilter.h>
#include <itkBinaryErodeImageFilter.h>
#include <itkBinaryFillholeImageFilter.h>
#include <itkBinaryMorphologicalClosingImageFilter.h>
#include <itkBinaryMorphologicalOpeningImageFilter.h>
#include <itkConstantPadImageFilter.h>
#include <itkCropImageFilter.h>
#include <itkFlatStructuringElement.h>

#include <algorithm>
#include <cmath>

namespace peer {

namespace {

using Kernel = itk::FlatStructuringElement<3>;
using Dilation = itk::BinaryDilateImageFilter<MaskImage, MaskImage, Kernel>;
using Erosion = itk::BinaryErodeImageFilter<MaskImage, MaskImage, Kernel>;
using Opening = itk::BinaryMorphologicalOpeningImageFilter<MaskImage, MaskImage, Kernel>;
using Closing = itk::BinaryMorphologicalClosingImageFilter<MaskImage, MaskImage, Kernel>;

Kernel ballKernel(const glm::dvec3& spacingMm, double radiusMm)
{
    Kernel kernel;
    kernel.SetDecomposable(false);
    kernel.SetRadius(ballRadius(spacingMm, radiusMm));
    for (unsigned at = 0; at < kernel.Size(); ++at)
        kernel[at] = isInBall(kernel.GetOffset(at), spacingMm, radiusMm);
    return kernel;
}

bool isInBody(
    const itk::Offset<3>& step, const glm::dvec3& spacingMm, const std::array<AxisReach, 3>& reach)
{
    double sum = 0.0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (step[axis] == 0)
            continue;
        const AxisReach& its = reach[axis];
        const double limit = step[axis] < 0 ? its.backwardsMm : its.forwardsMm;
        if (!(limit > 0.0))
            return false;
        const double part = double(step[axis]) * spacingMm[static_cast<int>(axis)] / limit;
        sum += part * part;
    }
    return sum <= 1.0 + ballSlack;
}

Kernel bodyKernel(const glm::dvec3& spacingMm, const std::array<AxisReach, 3>& reach)
{
    Kernel kernel;
    kernel.SetDecomposable(false);
    itk::Size<3> radius;
    for (unsigned axis = 0; axis < 3; ++axis)
        radius[axis] = static_cast<itk::SizeValueType>(
            std::ceil(std::max(reach[axis].backwardsMm, reach[axis].forwardsMm)
                / spacingMm[static_cast<int>(axis)]));
    kernel.SetRadius(radius);
    for (unsigned at = 0; at < kernel.Size(); ++at)
        kernel[at] = isInBody(kernel.GetOffset(at), spacingMm, reach);
    return kernel;
}

template <class Filter> ItkMask filtered(const MaskImage* image, const Kernel& kernel)
{
    const auto filter = Filter::New();
    filter->SetInput(image);
    filter->SetKernel(kernel);
    filter->SetForegroundValue(1);
    return maskFrom(*filter);
}

ItkMask wrapped(const MaskImage* image, const Kernel& kernel)
{
    MaskImage::SizeType margin = kernel.GetRadius();
    for (auto& voxels : margin)
        ++voxels;
    const auto pad = itk::ConstantPadImageFilter<MaskImage, MaskImage>::New();
    pad->SetInput(image);
    pad->SetPadBound(margin);
    pad->SetConstant(0);
    const auto dilate = Dilation::New();
    dilate->SetInput(pad->GetOutput());
    dilate->SetKernel(kernel);
    dilate->SetForegroundValue(1);
    const auto fill = itk::BinaryFillholeImageFilter<MaskImage>::New();
    fill->SetInput(dilate->GetOutput());
    fill->SetForegroundValue(1);
    const auto erode = Erosion::New();
    erode->SetInput(fill->GetOutput());
    erode->SetKernel(kernel);
    erode->SetForegroundValue(1);
    const auto crop = itk::CropImageFilter<MaskImage, MaskImage>::New();
    crop->SetInput(erode->GetOutput());
    crop->SetBoundaryCropSize(margin);
    return maskFrom(*crop);
}

} // namespace

ItkMask itkByBall(const GridMask& mask, double radiusMm, ItkBallFilter filter)
{
    const MaskImage::Pointer image = imageOn(mask);
    const Kernel kernel = ballKernel(mask.spacingMm, radiusMm);
    switch (filter) {
    case ItkBallFilter::Dilate:
        return filtered<Dilation>(image, kernel);
    case ItkBallFilter::Erode:
        return filtered<Erosion>(image, kernel);
    case ItkBallFilter::Open:
        return filtered<Opening>(image, kernel);
    case ItkBallFilter::Close:
        return filtered<Closing>(image, kernel);
    case ItkBallFilter::Wrap:
        break;
    }
    return wrapped(image, kernel);
}

ItkMask itkDilatedBySides(const GridMask& mask, const std::array<AxisReach, 3>& reach)
{
    return filtered<Dilation>(imageOn(mask), bodyKernel(mask.spacingMm, reach));
}

} // namespace peer
