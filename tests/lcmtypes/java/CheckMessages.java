import drake.lcmt_point_cloud;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.util.Arrays;
import lcm.logging.Log;
import quadrille.quadric_t;
import quadrille.quadrics_t;

/** Reads logs with the messages for Java: CheckMessages CLOUDS.lcm RESULTS.lcm */
public class CheckMessages {
  static void check(boolean holds, String what) {
    if (!holds) throw new RuntimeException(what);
  }

  static quadrics_t nextQuadrics(Log results) throws Exception {
    Log.Event event = results.readNext();
    while (!event.channel.equals("QUADRICS")) event = results.readNext();
    return new quadrics_t(event.data);
  }

  public static void main(String[] arguments) throws Exception {
    Log clouds = new Log(arguments[0], "r"), results = new Log(arguments[1], "r");
    lcmt_point_cloud first = null;
    int planes = 0;
    try {
      while (true) {
        Log.Event event = clouds.readNext();
        lcmt_point_cloud cloud = new lcmt_point_cloud(event.data);
        check(cloud.data.length == cloud.width * cloud.height * cloud.point_step, "data's size");
        // What was decoded and copied is encoded as it was.
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        cloud.copy().encode(new DataOutputStream(bytes));
        check(Arrays.equals(bytes.toByteArray(), event.data), "a cloud is encoded as another");
        quadrics_t found = nextQuadrics(results);
        check(found.utime == cloud.utime, "the time of a cloud");
        check(found.points_read == cloud.width * cloud.height, "points that were read");
        for (quadric_t quadric : found.detections) {
          if (quadric.type.equals("plane")) ++planes;
        }
        first = cloud;
      }
    } catch (EOFException end) {
      check(first != null && planes > 0, "there are no clouds, or no planes");
    }
    check(lcmt_point_cloud.LCM_FINGERPRINT == 0x17f2c128b5d25a95L, "the fingerprint");
    System.out.println(planes + " planes");
  }
}
