// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkValues.h"

#include "tests/peers/ItkImages.h"

#include <itkAndImageFilter.h>
#include <itkBinaryNotImageFilter.h>
#include <itkBinaryThresholdImageFilter.h>
#include <itkFlipImageFilter.h>
#include <itkHistogram.h>
#include <itkMaskImageFilter.h>
#include <itkNearestNeighborInterpolateImageFunction.h>
#include <itkOrImageFilter.h>
#include <itkOtsuMultipleThresholdsCalculator.h>
#include <itkResampleImageFilter.h>

namespace peer {

ItkMask itkThreshold(
    const glm::ivec3& size, std::span<const float> values, float lower, float upper)
{
    const auto filter = itk::BinaryThresholdImageFilter<itk::Image<float, 3>, MaskImage>::New();
    filter->SetInput(imageOn(size, glm::dvec3(1.0), values));
    filter->SetLowerThreshold(lower);
    filter->SetUpperThreshold(upper);
    filter->SetInsideValue(1);
    filter->SetOutsideValue(0);
    return maskFrom(*filter);
}

ItkOtsu itkOtsu(
    std::span<const std::uint32_t> counts, double minimum, double maximum, int thresholds)
{
    using Histogram = itk::Statistics::Histogram<double>;
    const auto histogram = Histogram::New();
    histogram->SetMeasurementVectorSize(1);
    Histogram::SizeType bins(1);
    bins.Fill(counts.size());
    Histogram::MeasurementVectorType low(1);
    Histogram::MeasurementVectorType high(1);
    low.Fill(minimum);
    high.Fill(maximum);
    histogram->Initialize(bins, low, high);
    for (std::size_t bin = 0; bin < counts.size(); ++bin)
        histogram->SetFrequency(bin, counts[bin]);
    const auto calculator = itk::OtsuMultipleThresholdsCalculator<Histogram>::New();
    calculator->SetInputHistogram(histogram);
    calculator->SetNumberOfThresholds(static_cast<itk::SizeValueType>(thresholds));
    ItkOtsu otsu;
    const auto start = std::chrono::steady_clock::now();
    calculator->Compute();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    otsu.milliseconds = spent.count();
    otsu.thresholds.assign(calculator->GetOutput().begin(), calculator->GetOutput().end());
    return otsu;
}

ItkMask itkInverted(const GridMask& mask)
{
    const auto filter = itk::BinaryNotImageFilter<MaskImage>::New();
    filter->SetInput(imageOn(mask));
    filter->SetForegroundValue(1);
    filter->SetBackgroundValue(0);
    return maskFrom(*filter);
}

ItkMask itkCombined(const GridMask& mask, const GridMask& other, ItkSetOperation operation)
{
    const MaskImage::Pointer one = imageOn(mask);
    MaskImage::Pointer two = imageOn(other);
    if (operation == ItkSetOperation::Union) {
        const auto filter = itk::OrImageFilter<MaskImage>::New();
        filter->SetInput1(one);
        filter->SetInput2(two);
        return maskFrom(*filter);
    }
    const auto invert = itk::BinaryNotImageFilter<MaskImage>::New();
    invert->SetInput(two);
    invert->SetForegroundValue(1);
    invert->SetBackgroundValue(0);
    if (operation == ItkSetOperation::Subtract)
        two = invert->GetOutput();
    const auto filter = itk::AndImageFilter<MaskImage>::New();
    filter->SetInput1(one);
    filter->SetInput2(two);
    return maskFrom(*filter);
}

ItkMask itkFlipped(const GridMask& mask, int axis)
{
    const auto filter = itk::FlipImageFilter<MaskImage>::New();
    filter->SetInput(imageOn(mask));
    itk::FlipImageFilter<MaskImage>::FlipAxesArrayType axes(false);
    axes[static_cast<unsigned>(axis)] = true;
    filter->SetFlipAxes(axes);
    return maskFrom(*filter);
}

ItkMask itkWithMirrorImage(const GridMask& mask, int axis, int voxel)
{
    const auto along = static_cast<unsigned>(axis);
    const MaskImage::Pointer image = imageOn(mask);
    MaskImage::PointType origin;
    origin.Fill(0.0);
    origin[along] = -voxel * mask.spacingMm[axis]; // the plane goes through the origin
    image->SetOrigin(origin);
    const auto flip = itk::FlipImageFilter<MaskImage>::New();
    flip->SetInput(image);
    itk::FlipImageFilter<MaskImage>::FlipAxesArrayType axes(false);
    axes[along] = true;
    flip->SetFlipAxes(axes);
    flip->FlipAboutOriginOn();
    const auto resample = itk::ResampleImageFilter<MaskImage, MaskImage>::New();
    resample->SetInput(flip->GetOutput());
    resample->SetInterpolator(
        itk::NearestNeighborInterpolateImageFunction<MaskImage, double>::New());
    resample->SetReferenceImage(image);
    resample->UseReferenceImageOn();
    resample->SetDefaultPixelValue(0);
    const auto both = itk::OrImageFilter<MaskImage>::New();
    both->SetInput1(image);
    both->SetInput2(resample->GetOutput());
    both->InPlaceOff(); // the voxels are the caller's
    return maskFrom(*both);
}

ItkValues itkMasked(std::span<const float> values, const GridMask& mask, float outside)
{
    using Values = itk::Image<float, 3>;
    const auto filter = itk::MaskImageFilter<Values, MaskImage>::New();
    const MaskImage::Pointer masking = imageOn(mask);
    filter->SetInput(imageOn(mask.size, mask.spacingMm, values));
    filter->InPlaceOff();
    filter->SetMaskImage(masking);
    filter->SetOutsideValue(outside);
    ItkValues masked;
    masked.milliseconds = timeOf(*filter);
    const float* first = filter->GetOutput()->GetBufferPointer();
    masked.values.assign(first, first + values.size());
    return masked;
}

} // namespace peer
