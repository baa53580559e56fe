#pragma once

// Colours that stay apart for colour-blind readers and in print (Okabe, Ito 2008), with the greys of frames
// and texts.

#include <array>
#include <string_view>

namespace gcslab::palette {

inline constexpr std::string_view kBlack = "#000000";
inline constexpr std::string_view kBlue = "#0072B2";
inline constexpr std::string_view kVermillion = "#D55E00";
inline constexpr std::string_view kGreen = "#009E73";
inline constexpr std::string_view kOrange = "#E69F00";
inline constexpr std::string_view kSky = "#56B4E9";
inline constexpr std::string_view kPurple = "#CC79A7";

/// For lines, in the order of use. The palette's yellow is too faint for a thin line on white.
inline constexpr std::array kLines = {kBlue, kVermillion, kGreen, kOrange, kPurple, kSky, kBlack};

inline constexpr std::string_view kText = "#202020";
inline constexpr std::string_view kQuietText = "#606060";
inline constexpr std::string_view kFrame = "#505050";
inline constexpr std::string_view kGrid = "#DDDDDD";
inline constexpr std::string_view kBand = "#E4E4E4";
/// Of covers.
inline constexpr std::string_view kKept = "#E69F00";
inline constexpr std::string_view kVisited = "#C4C4C4";
/// Of searches.
inline constexpr std::string_view kRemovedPart = "#E3EFF8";
inline constexpr std::string_view kReducedBorder = "#7FB3D9";
inline constexpr std::string_view kEmptyBox = "#D2D2D2";
inline constexpr std::string_view kRootBox = "#A9DCC6";
inline constexpr std::string_view kUndecidedBox = "#F3CE80";
inline constexpr std::string_view kPendingBox = "#FBF6C8";

}  // namespace gcslab::palette
