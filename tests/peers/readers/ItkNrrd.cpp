// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/readers/ItkNrrd.h"

#include <itkImageFileReader.h>
#include <itkMetaDataObject.h>
#include <itkNrrdImageIO.h>

namespace peer {

ItkNrrd readItkNrrd(const std::string& file)
{
    using Image = itk::Image<std::uint8_t, 3>;
    ItkNrrd found;
    const auto reader = itk::ImageFileReader<Image>::New();
    reader->SetImageIO(itk::NrrdImageIO::New());
    reader->SetFileName(file);
    try {
        reader->Update();
    } catch (const itk::ExceptionObject& problem) {
        found.error = problem.GetDescription();
        return found;
    }
    const Image& image = *reader->GetOutput();
    const auto size = image.GetLargestPossibleRegion().GetSize();
    for (int axis = 0; axis < 3; ++axis) {
        const auto itkAxis = static_cast<unsigned>(axis);
        found.size[axis] = static_cast<int>(size[itkAxis]);
        found.indexToWorld[3][axis] = image.GetOrigin()[itkAxis];
        for (int row = 0; row < 3; ++row)
            found.indexToWorld[axis][row] =
                image.GetDirection()[static_cast<unsigned>(row)][itkAxis]
                * image.GetSpacing()[itkAxis];
    }
    const std::uint8_t* first = image.GetBufferPointer();
    found.voxels.assign(first, first + size[0] * size[1] * size[2]);
    const itk::MetaDataDictionary& dictionary = reader->GetImageIO()->GetMetaDataDictionary();
    for (const std::string& key : dictionary.GetKeys()) {
        std::string value;
        if (itk::ExposeMetaData(dictionary, key, value))
            found.words[key] = value;
    }
    return found;
}

} // namespace peer
