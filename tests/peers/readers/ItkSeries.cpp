// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/readers/ItkSeries.h"

#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkImageSeriesReader.h>

#include <chrono>

namespace peer {

ItkSeries readItkSeries(const std::string& folder)
{
    using Image = itk::Image<std::int16_t, 3>;
    ItkSeries found;
    try {
        const auto start = std::chrono::steady_clock::now();
        const auto names = itk::GDCMSeriesFileNames::New();
        names->SetUseSeriesDetails(true);
        names->SetDirectory(folder);
        const std::vector<std::string>& series = names->GetSeriesUIDs();
        if (series.size() != 1) {
            found.error = "it finds " + std::to_string(series.size()) + " series";
            return found;
        }
        const auto reader = itk::ImageSeriesReader<Image>::New();
        reader->SetImageIO(itk::GDCMImageIO::New());
        reader->SetFileNames(names->GetFileNames(series.front()));
        reader->Update();
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        const Image::Pointer image = reader->GetOutput();
        const Image::SizeType size = image->GetLargestPossibleRegion().GetSize();
        found.size = glm::ivec3(int(size[0]), int(size[1]), int(size[2]));
        const std::int16_t* first = image->GetBufferPointer();
        found.values.assign(first, first + size[0] * size[1] * size[2]);
        found.milliseconds = spent.count();
    } catch (const itk::ExceptionObject& why) {
        found.error = why.GetDescription();
    }
    return found;
}

} // namespace peer
