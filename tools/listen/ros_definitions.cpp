#include "tools/listen/ros_messages.hpp"

// The definitions of ROS 2, without their comments.
const articam::listen::MessageType articam::listen::kJointState{"sensor_msgs/msg/JointState",
                                                                R"(std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
)"};

const articam::listen::MessageType articam::listen::kPoseWithCovarianceStamped{
    "geometry_msgs/msg/PoseWithCovarianceStamped",
    R"(std_msgs/Header header
geometry_msgs/PoseWithCovariance pose
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
================================================================================
MSG: geometry_msgs/PoseWithCovariance
geometry_msgs/Pose pose
float64[36] covariance
================================================================================
MSG: geometry_msgs/Pose
geometry_msgs/Point position
geometry_msgs/Quaternion orientation
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
)"};

// Ours. Fields are only ever added, at the end.
const articam::listen::MessageType articam::listen::kEstimate{
    "articam_msgs/msg/Estimate",
    R"(# What the board says at every turn of its loop, also when there is no estimate. SI units.
uint8 INITIALISING=0
uint8 TRACKING=1
uint8 DEGRADED=2
uint8 COASTING=3
uint8 LOST=4
uint8 FAULT=5
uint8 HELD=0
uint8 WEAK=1
uint8 OBSERVED=2

std_msgs/Header header     # capture, on the listener's clock
uint64 session             # drawn at each start of the board's program
uint64 model_hash
string model
uint32 number              # of the packet in its session
uint32 frame               # of the camera, dropped ones included
int64 t_capture_ns         # the board's monotonic clock
int64 t_send_ns
float64 age_s              # from capture to receipt
bool age_is_exact          # false: the way of the quickest packet is left out
uint8 status
uint8 reason
string status_name
string reason_name
bool valid                 # otherwise pose, joints, velocity and covariance are empty
float64[] t_cam_obj        # pose of the object in the camera's frame: x y z qw qx qy qz
string[] joint_names
float64[] joints           # rad or m
float64[] velocity         # of translation, rotation (in the camera's frame) and joints
float64[] covariance       # upper triangle by rows, in the same order
uint8[] observability      # in the same order
uint32 matched             # markers
float64 rms_px
float64[] t_base_obj       # in the robot's control frame; empty where that is not known
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
)"};
