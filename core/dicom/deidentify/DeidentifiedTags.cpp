// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/deidentify/DeidentifiedTags.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>

namespace core {

namespace {

template <std::size_t N> bool holds(const std::array<DcmTagKey, N>& tags, const DcmTagKey& tag)
{
    return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

const std::array ofImages{DCM_ImageType, DCM_Modality, DCM_ConversionType, DCM_BodyPartExamined,
    DCM_ScanningSequence, DCM_SequenceVariant, DCM_ScanOptions, DCM_MRAcquisitionType,
    DCM_SliceThickness, DCM_KVP, DCM_RepetitionTime, DCM_EchoTime, DCM_InversionTime,
    DCM_NumberOfAverages, DCM_ImagingFrequency, DCM_ImagedNucleus, DCM_EchoNumbers,
    DCM_MagneticFieldStrength, DCM_SpacingBetweenSlices, DCM_EchoTrainLength, DCM_PixelBandwidth,
    DCM_FlipAngle, DCM_ReconstructionDiameter, DCM_DistanceSourceToDetector,
    DCM_DistanceSourceToPatient, DCM_GantryDetectorTilt, DCM_TableHeight, DCM_RotationDirection,
    DCM_ExposureTime, DCM_XRayTubeCurrent, DCM_Exposure, DCM_FilterType, DCM_GeneratorPower,
    DCM_FocalSpots, DCM_ConvolutionKernel, DCM_PatientPosition, DCM_AcquisitionNumber,
    DCM_InstanceNumber, DCM_SeriesNumber, DCM_ImagePositionPatient, DCM_ImageOrientationPatient,
    DCM_SliceLocation, DCM_Laterality, DCM_PatientOrientation, DCM_TemporalPositionIdentifier,
    DCM_NumberOfTemporalPositions, DCM_TriggerTime, DCM_WindowCenter, DCM_WindowWidth,
    DCM_VOILUTFunction, DCM_RescaleIntercept, DCM_RescaleSlope, DCM_RescaleType,
    DCM_PresentationLUTShape, DCM_LossyImageCompression, DCM_LossyImageCompressionRatio,
    DCM_LossyImageCompressionMethod, DCM_BurnedInAnnotation, DCM_RecognizableVisualFeatures,
    DCM_Units, DCM_SeriesType, DCM_CorrectedImage, DCM_DecayCorrection, DCM_DecayFactor,
    DCM_ImageIndex, DCM_FrameReferenceTime};

const std::array ofPixels{DCM_SpecificCharacterSet, DCM_SamplesPerPixel,
    DCM_PhotometricInterpretation, DCM_PlanarConfiguration, DCM_NumberOfFrames, DCM_Rows,
    DCM_Columns, DCM_PixelSpacing, DCM_PixelAspectRatio, DCM_BitsAllocated, DCM_BitsStored,
    DCM_HighBit, DCM_PixelRepresentation, DCM_SmallestImagePixelValue, DCM_LargestImagePixelValue,
    DCM_PixelPaddingValue, DCM_PixelPaddingRangeLimit, DCM_PixelData, DCM_LUTDescriptor,
    DCM_LUTData, DCM_ModalityLUTType, DCM_ImagesInAcquisition};

/// Of SEG, RTSTRUCT and SR: codes, numbers and what they refer to.
const std::array ofResults{DCM_CodeValue, DCM_CodingSchemeDesignator, DCM_CodeMeaning,
    DCM_ReferencedFrameNumber, DCM_ReferencedSegmentNumber, DCM_SegmentNumber,
    DCM_SegmentAlgorithmType, DCM_RecommendedDisplayCIELabValue, DCM_SegmentationType,
    DCM_SegmentationFractionalType, DCM_MaximumFractionalValue, DCM_SegmentsOverlap,
    DCM_DimensionIndexValues, DCM_DimensionIndexPointer, DCM_FunctionalGroupPointer,
    DCM_SpatialLocationsPreserved, DCM_ROINumber, DCM_ROIGenerationAlgorithm, DCM_ROIDisplayColor,
    DCM_ReferencedROINumber, DCM_ContourNumber, DCM_ContourGeometricType, DCM_NumberOfContourPoints,
    DCM_ContourData, DCM_ObservationNumber, DCM_RTROIInterpretedType, DCM_ApprovalStatus,
    DCM_ValueType, DCM_RelationshipType, DCM_ContinuityOfContent, DCM_NumericValue,
    DCM_TemplateIdentifier, DCM_MappingResource, DCM_CompletionFlag, DCM_VerificationFlag,
    DCM_PatientIdentityRemoved, DCM_DeidentificationMethod,
    DCM_LongitudinalTemporalInformationModified, DCM_DimensionOrganizationType,
    DCM_InStackPositionNumber, DCM_TemporalPositionIndex, DCM_ReferencedContentItemIdentifier,
    DCM_GraphicType, DCM_GraphicData};

/// Names and texts in them, which are neutral before where Burin writes them.
const std::array ownTexts{DCM_SegmentLabel, DCM_SegmentDescription, DCM_SegmentAlgorithmName,
    DCM_TrackingID, DCM_ContentLabel, DCM_DimensionDescriptionLabel, DCM_StructureSetLabel,
    DCM_ROIName, DCM_TextValue};

const std::array sequences{DCM_SourceImageSequence, DCM_DerivationImageSequence,
    DCM_DerivationCodeSequence, DCM_PurposeOfReferenceCodeSequence, DCM_ModalityLUTSequence,
    DCM_SegmentSequence, DCM_SegmentedPropertyCategoryCodeSequence,
    DCM_SegmentedPropertyTypeCodeSequence, DCM_SegmentedPropertyTypeModifierCodeSequence,
    DCM_AnatomicRegionSequence, DCM_AnatomicRegionModifierSequence,
    DCM_SharedFunctionalGroupsSequence, DCM_PerFrameFunctionalGroupsSequence,
    DCM_FrameContentSequence, DCM_PlanePositionSequence, DCM_PlaneOrientationSequence,
    DCM_PixelMeasuresSequence, DCM_SegmentIdentificationSequence, DCM_DimensionOrganizationSequence,
    DCM_DimensionIndexSequence, DCM_ReferencedSeriesSequence, DCM_ReferencedInstanceSequence,
    DCM_ReferencedFrameOfReferenceSequence, DCM_RTReferencedStudySequence,
    DCM_RTReferencedSeriesSequence, DCM_ContourImageSequence, DCM_StructureSetROISequence,
    DCM_ROIContourSequence, DCM_ContourSequence, DCM_RTROIObservationsSequence,
    DCM_RTROIIdentificationCodeSequence, DCM_ConceptNameCodeSequence, DCM_ConceptCodeSequence,
    DCM_MeasuredValueSequence, DCM_MeasurementUnitsCodeSequence, DCM_ReferencedSOPSequence,
    DCM_ContentTemplateSequence, DCM_CurrentRequestedProcedureEvidenceSequence,
    DCM_PerformedProcedureCodeSequence, DCM_ReferencedPerformedProcedureStepSequence,
    DCM_DeidentificationMethodCodeSequence};

const std::array needed{DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex,
    DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber, DCM_ContentCreatorName,
    DCM_ContentDescription, DCM_PositionReferenceIndicator, DCM_OperatorsName, DCM_ROIInterpreter};

} // namespace

TagFate fateOf(const DcmTagKey& tag)
{
    if (holds(ofImages, tag) || holds(ofPixels, tag) || holds(ofResults, tag))
        return TagFate::Keep;
    if (holds(sequences, tag))
        return TagFate::Enter;
    if (holds(ownTexts, tag))
        return TagFate::OwnText;
    if (tag == DCM_ContentSequence)
        return TagFate::OwnItems;
    if (holds(needed, tag))
        return TagFate::Empty;
    const std::array neededDates{DCM_ContentDate, DCM_StudyDate, DCM_StructureSetDate};
    const std::array neededTimes{DCM_ContentTime, DCM_StudyTime, DCM_StructureSetTime};
    if (holds(neededDates, tag))
        return TagFate::NeededDate;
    if (holds(neededTimes, tag))
        return TagFate::NeededTime;
    const std::array dates{DCM_SeriesDate, DCM_AcquisitionDate, DCM_InstanceCreationDate};
    const std::array times{DCM_SeriesTime, DCM_AcquisitionTime, DCM_InstanceCreationTime};
    if (holds(dates, tag))
        return TagFate::Date;
    if (holds(times, tag))
        return TagFate::Time;
    const std::array device{DCM_Manufacturer, DCM_ManufacturerModelName, DCM_DeviceSerialNumber,
        DCM_SoftwareVersions, DCM_StationName, DCM_GantryID, DCM_SecondaryCaptureDeviceManufacturer,
        DCM_SecondaryCaptureDeviceManufacturerModelName,
        DCM_SecondaryCaptureDeviceSoftwareVersions};
    if (holds(device, tag))
        return TagFate::Device;
    const std::array descriptions{
        DCM_StudyDescription, DCM_SeriesDescription, DCM_ProtocolName, DCM_DerivationDescription};
    return holds(descriptions, tag) ? TagFate::Description : TagFate::Remove;
}

} // namespace core
