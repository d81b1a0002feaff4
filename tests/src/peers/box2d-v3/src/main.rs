//! Measures native Box2D v3 on a scene of `carom bench`.
//!
//! Arguments: the scene's name, the file that describes it, and the file to which the poses at the
//! end are written. `SceneFile` in `carom.lab.bench` tells the format of both files, and
//! docs/lab/BENCHMARKS.md how entrants take turns.
//!
//! `box2d-v3 sleep STEPS SCENE...` instead prints the step at which all bodies of each scene sleep.

use boxdd_sys::ffi::*;
use std::fmt::Write as _;
use std::io::{Read, Write as _};

/// Substeps of each step, Box2D's own default.
const SUBSTEPS: i32 = 4;

/// Number of slices between which the other entrants have their turns.
const SLICES: usize = 12;

struct Scene {
    name: String,
    warm: usize,
    measured: usize,
    seconds: f32,
    lines: Vec<Vec<String>>,
}

impl Scene {
    fn read(name: &str, path: &str) -> Scene {
        let text = std::fs::read_to_string(path).expect("the scene's file can be read");
        let lines: Vec<Vec<String>> = text
            .lines()
            .map(|line| line.split(' ').map(str::to_owned).collect())
            .collect();
        let run = lines.iter().find(|line| line[0] == "run").expect("a line `run`");
        Scene {
            name: name.to_owned(),
            warm: number(&run[1]) as usize,
            measured: number(&run[2]) as usize,
            seconds: 1.0 / number(&run[3]),
            lines,
        }
    }
}

fn number(word: &str) -> f32 {
    word.parse().unwrap_or_else(|_| panic!("not a number: {word}"))
}

fn numbers(words: &[String]) -> Vec<f32> {
    words.iter().map(|word| number(word)).collect()
}

/// A world of Box2D with its bodies in the order of the scene's file.
struct World {
    id: b2WorldId,
    bodies: Vec<b2BodyId>,
    dynamic: usize,
}

impl World {
    fn of(scene: &Scene) -> World {
        let mut world = World {
            id: unsafe { b2CreateWorld(&b2DefaultWorldDef()) },
            bodies: Vec::new(),
            dynamic: 0,
        };
        for line in &scene.lines {
            match line[0].as_str() {
                "world" => world.define(&numbers(&line[1..])),
                "body" => world.body(&line[1], &numbers(&line[2..])),
                "shape" => world.shape(&numbers(&line[1..])),
                "revolute" => world.revolute(&numbers(&line[1..])),
                _ => {}
            }
        }
        world
    }

    fn define(&mut self, n: &[f32]) {
        unsafe {
            b2World_SetGravity(self.id, b2Vec2 { x: n[0], y: n[1] });
            b2World_EnableSleeping(self.id, n[2] != 0.0);
            b2World_EnableContinuous(self.id, false);
        }
    }

    fn body(&mut self, kind: &str, n: &[f32]) {
        unsafe {
            let mut def = b2DefaultBodyDef();
            def.type_ = match kind {
                "static" => b2BodyType_b2_staticBody,
                "kinematic" => b2BodyType_b2_kinematicBody,
                _ => b2BodyType_b2_dynamicBody,
            };
            self.dynamic += (kind == "dynamic") as usize;
            def.position = b2Vec2 { x: n[0], y: n[1] };
            def.rotation = b2Rot { c: n[2], s: n[3] };
            def.linearVelocity = b2Vec2 { x: n[4], y: n[5] };
            def.angularVelocity = n[6];
            def.gravityScale = n[7];
            def.isAwake = n[8] != 0.0;
            self.bodies.push(b2CreateBody(self.id, &def));
        }
    }

    fn shape(&mut self, n: &[f32]) {
        let body = *self.bodies.last().expect("a shape follows its body");
        let radius = n[4];
        let points: Vec<b2Vec2> = n[6..].chunks(2).map(|p| b2Vec2 { x: p[0], y: p[1] }).collect();
        unsafe {
            let mut def = b2DefaultShapeDef();
            def.density = n[0];
            def.material.friction = n[1];
            def.material.restitution = n[2];
            def.filter.groupIndex = n[3] as i32;
            match points.len() {
                1 => {
                    b2CreateCircleShape(body, &def, &b2Circle { center: points[0], radius });
                }
                2 => {
                    let capsule = b2Capsule { center1: points[0], center2: points[1], radius };
                    b2CreateCapsuleShape(body, &def, &capsule);
                }
                count => {
                    let hull = b2ComputeHull(points.as_ptr(), count as i32);
                    b2CreatePolygonShape(body, &def, &b2MakePolygon(&hull, radius));
                }
            }
        }
    }

    fn revolute(&mut self, n: &[f32]) {
        let point = b2Vec2 { x: n[2], y: n[3] };
        let (a, b) = (self.bodies[n[0] as usize], self.bodies[n[1] as usize]);
        unsafe {
            let mut def = b2DefaultRevoluteJointDef();
            def.base.bodyIdA = a;
            def.base.bodyIdB = b;
            def.base.localFrameA.p = b2Body_GetLocalPoint(a, point);
            def.base.localFrameB.p = b2Body_GetLocalPoint(b, point);
            b2CreateRevoluteJoint(self.id, &def);
        }
    }

    fn step(&self, scene: &Scene) {
        unsafe { b2World_Step(self.id, scene.seconds, SUBSTEPS) }
    }

    fn awake(&self) -> i32 {
        unsafe { b2World_GetAwakeBodyCount(self.id) }
    }

    fn poses(&self) -> String {
        let mut text = String::new();
        for &body in &self.bodies {
            unsafe {
                let pose = b2Body_GetTransform(body);
                let v = b2Body_GetLinearVelocity(body);
                let w = b2Body_GetAngularVelocity(body);
                let awake = b2Body_IsAwake(body) as u8;
                let (p, q) = (pose.p, pose.q);
                let _ = writeln!(text, "{} {} {} {} {} {} {w} {awake}", p.x, p.y, q.c, q.s, v.x, v.y);
            }
        }
        text
    }
}

impl Drop for World {
    fn drop(&mut self) {
        unsafe { b2DestroyWorld(self.id) }
    }
}

fn seconds(clock: libc::clockid_t) -> f64 {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    unsafe { libc::clock_gettime(clock, &mut time) };
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

fn take_turn() {
    let mut byte = [0];
    std::io::stdin().read_exact(&mut byte).expect("bench gives the turn");
}

fn pass_turn() {
    println!("turn");
    std::io::stdout().flush().expect("bench reads");
    take_turn();
}

fn median_and_p99(times: &mut [f64]) -> (f64, f64) {
    times.sort_by(f64::total_cmp);
    let p99 = (0.99 * times.len() as f64).ceil() as usize - 1;
    (times[times.len() / 2] * 1e3, times[p99] * 1e3)
}

/// Prints when all bodies of scenes sleep, or how many are awake at the last step.
fn tell_sleep(steps: &str, files: &[String]) {
    for file in files {
        let scene = Scene::read(file, file);
        let world = World::of(&scene);
        let asleep = (1..=number(steps) as usize).find(|_| {
            world.step(&scene);
            world.awake() == 0
        });
        match asleep {
            Some(step) => println!("{file}: asleep at step {step}"),
            None => println!("{file}: {} of {} awake", world.awake(), world.dynamic),
        }
    }
}

fn main() {
    let args: Vec<String> = std::env::args().collect();
    if args.len() > 3 && args[1] == "sleep" {
        return tell_sleep(&args[2], &args[3..]);
    }
    let [_, name, file, poses] = &args[..] else {
        eprintln!("Error: only scenes can be measured: box2d-v3 NAME SCENE POSES");
        std::process::exit(2);
    };
    take_turn();
    let scene = Scene::read(name, file);
    let rehearsal = World::of(&scene);
    (0..scene.warm + scene.measured).for_each(|_| rehearsal.step(&scene));
    drop(rehearsal);
    let world = World::of(&scene);
    (0..scene.warm).for_each(|_| world.step(&scene));
    let (mut cpu, mut wall) = (Vec::new(), Vec::new());
    while cpu.len() < scene.measured {
        pass_turn();
        for _ in 0..scene.measured.div_ceil(SLICES).min(scene.measured - cpu.len()) {
            let from = (seconds(libc::CLOCK_THREAD_CPUTIME_ID), seconds(libc::CLOCK_MONOTONIC));
            world.step(&scene);
            cpu.push(seconds(libc::CLOCK_THREAD_CPUTIME_ID) - from.0);
            wall.push(seconds(libc::CLOCK_MONOTONIC) - from.1);
        }
    }
    std::fs::write(poses, world.poses()).expect("the poses' file can be written");
    let (median, p99) = median_and_p99(&mut cpu);
    let (wall_median, _) = median_and_p99(&mut wall);
    println!(
        "{{\"scene\":\"{}\",\"engine\":\"box2d-v3\",\"kernels\":\"\",\"threads\":1,\"bodies\":{},\
         \"joints\":0,\"awake\":0,\"steps\":{},\"medianMs\":{median},\"p99Ms\":{p99},\
         \"wallMs\":{wall_median},\"allocatedBytesPerStep\":null,\"hash\":\"\",\
         \"kineticEnergy\":null,\"maxPenetration\":null,\"deepPairs\":null,\"jointGap\":null,\
         \"stages\":{{}},\"speedUp\":null,\"ceiling\":null,\"share\":null,\"ratios\":{{}},\
         \"valid\":true,\"fault\":\"\"}}",
        scene.name,
        world.dynamic,
        cpu.len()
    );
}
