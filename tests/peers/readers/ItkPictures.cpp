// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/readers/ItkPictures.h"

#include <itkImageFileReader.h>
#include <itkImageSeriesReader.h>
#include <itkPNGImageIO.h>
#include <itkTIFFImageIO.h>

namespace peer {

namespace {

using Image = itk::Image<double, 3>;

bool isPng(const std::string& file)
{
    return file.size() > 4 && file.compare(file.size() - 4, 4, ".png") == 0;
}

itk::ImageIOBase::Pointer ioOf(const std::string& file)
{
    itk::ImageIOBase::Pointer io;
    if (isPng(file))
        io = itk::PNGImageIO::New();
    else
        io = itk::TIFFImageIO::New();
    return io;
}

Image::Pointer readAll(const std::vector<std::string>& files)
{
    if (files.size() == 1) {
        const auto reader = itk::ImageFileReader<Image>::New();
        reader->SetImageIO(ioOf(files.front()));
        reader->SetFileName(files.front());
        reader->Update();
        return reader->GetOutput();
    }
    const auto reader = itk::ImageSeriesReader<Image>::New();
    reader->SetImageIO(ioOf(files.front()));
    reader->SetFileNames(files);
    reader->Update();
    return reader->GetOutput();
}

} // namespace

ItkPictures readItkPictures(const std::vector<std::string>& files)
{
    ItkPictures found;
    try {
        const Image::Pointer image = readAll(files);
        const Image::SizeType size = image->GetLargestPossibleRegion().GetSize();
        found.size = glm::ivec3(int(size[0]), int(size[1]), int(size[2]));
        const double* first = image->GetBufferPointer();
        found.values.assign(first, first + size[0] * size[1] * size[2]);
    } catch (const itk::ExceptionObject& why) {
        found.error = why.GetDescription();
    }
    return found;
}

} // namespace peer
